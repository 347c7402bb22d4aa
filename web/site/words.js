// What the front page and the race of fits say. They are parts of a static host's page alone, so these words are not in
// the engine's table.

/** @type {Record<string, [string, string]>} English, Korean */
const WORDS = {
  'car.ghost': ['A pen redraws the car. Touch anything to stop it.', '펜이 자동차를 다시 그립니다. 아무 곳이나 건드리면 멈춥니다.'],
  'car.turn': ['Your turn: draw a new roof.', '이제 직접 해 보세요. 지붕을 새로 그려 보세요.'],
  'hairs.ghost': ['Hairy strokes, one after the other. Each makes the one line better.', '성긴 획을 차례로 긋습니다. 그을 때마다 한 선이 더 나아집니다.'],
  'hairs.turn': ['Your turn: draw a hill with many quick strokes. They become one line.', '이제 직접 해 보세요. 빠른 획을 여러 번 그어 언덕을 그리면 한 선이 됩니다.'],
  'crocodile.ghost': ['The back is pulled, and its scales ride along.', '등을 당기면 비늘이 함께 따라갑니다.'],
  'crocodile.turn': ['Your turn: pull the back or the tail. The scales ride along.', '이제 직접 해 보세요. 등이나 꼬리를 당기면 비늘이 따라옵니다.'],
  'show': ['Show me', '보여 주기'],
  'again': ['Again', '다시 보기'],
  'close': ['Close', '닫기'],
  'hairs': ['Hairy strokes become one line', '성긴 획이 한 선으로'],
  'crocodile': ['Bend the crocodile', '악어 구부리기'],
  'race': ['Fit race', '맞춤 경주'],
  'manual': ['Manual', '설명서'],
  'links': ['Try', '해 보기'],
  'race.title': ['Fit race', '맞춤 경주'],
  'race.draw': ['Draw a line here. Three programs fit it while you draw.', '여기에 선을 그으세요. 그리는 동안 세 프로그램이 그 선을 맞춥니다.'],
  'race.tolerance': ['Tolerance, pixels', '허용 오차, 픽셀'],
  'race.pieces': ['pieces', '조각'],
  'race.points': ['points', '점'],
  'race.error': ['error, px', '오차, px'],
  'race.time': ['time, ms', '시간, ms'],
  'race.joints': ['joints', '이음'],
  'race.note': [
    'Each program gets the same samples and is asked for the same tolerance (the other two take its square). Pieces are cubic Bézier segments; points are control points, those that neighbours share counted once. The error is the greatest distance from a sample to the curve, measured in the same way for all. Batten draws as in the editor: it takes the tremor out of a stroke first, so its error can exceed the tolerance where the hand trembled. Its joints are C2, which cost one point each; the others only share a tangent, which costs three. So it may need more pieces and fewer points.',
    '세 프로그램이 같은 점들과 같은 허용 오차를 받습니다(다른 두 프로그램은 그 제곱을 받습니다). 조각은 3차 베지에 구간의 수이고, 점은 이웃과 공유하는 것을 한 번만 센 조절점의 수입니다. 오차는 점에서 곡선까지의 가장 먼 거리이며 모두 같은 방법으로 잽니다. Batten은 편집기와 같이 먼저 손떨림을 없애므로, 손이 떨린 곳에서는 오차가 허용 오차를 넘을 수 있습니다. 이음이 C2이므로 이음마다 점 하나가 들고, 접선만 같은 다른 두 프로그램은 셋이 듭니다. 그래서 조각은 더 많고 점은 더 적을 수 있습니다.'],
  'race.missing': ['The two other libraries could not be fetched.', '다른 두 라이브러리를 가져올 수 없습니다.'],
  'race.back': ['The editor', '편집기'],
  'race.clear': ['Clear', '지우기'],
};

/** @param {string} key @returns {string} in the language of the page */
export const say = (key) => WORDS[key]?.[document.documentElement.lang.startsWith('ko') ? 1 : 0] ?? '';
