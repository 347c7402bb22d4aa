// kurbo: the closest point on a path of cubics, segment by segment, as the library has it for one.
use kurbo::{CubicBez, ParamCurve, ParamCurveNearest, Point};
use std::time::Instant;

const WAVE: usize = 100;
const QUERIES: usize = 1000;
const ACCURACY: f64 = 1e-3;

struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / 9007199254740992.0
    }
}

/// The points of bench/timing.h, span by span: uniform spans by the classical matrix.
fn wave() -> Vec<CubicBez> {
    let mut random = Random(99);
    let p: Vec<(f64, f64)> = (0..WAVE)
        .map(|i| {
            let x = 10.0 * i as f64 + 4.0 * random.next();
            (x, 60.0 * random.next())
        })
        .collect();
    let mix = |a: (f64, f64), wa: f64, b: (f64, f64), wb: f64, c: (f64, f64), wc: f64| {
        Point::new(a.0 * wa + b.0 * wb + c.0 * wc, a.1 * wa + b.1 * wb + c.1 * wc)
    };
    p.windows(4)
        .map(|w| {
            CubicBez::new(
                mix(w[0], 1.0 / 6.0, w[1], 4.0 / 6.0, w[2], 1.0 / 6.0),
                mix(w[0], 0.0, w[1], 2.0 / 3.0, w[2], 1.0 / 3.0),
                mix(w[0], 0.0, w[1], 1.0 / 3.0, w[2], 2.0 / 3.0),
                mix(w[1], 1.0 / 6.0, w[2], 4.0 / 6.0, w[3], 1.0 / 6.0),
            )
        })
        .collect()
}

fn nearest(path: &[CubicBez], at: Point) -> f64 {
    path.iter().map(|c| c.eval(c.nearest(at, ACCURACY).0).distance(at)).fold(f64::INFINITY, f64::min)
}

/// By samples, then ever closer.
fn reference(path: &[CubicBez], at: Point) -> f64 {
    let mut least = f64::INFINITY;
    for c in path {
        let mut best = (f64::INFINITY, 0.0);
        for i in 0..=400 {
            let t = i as f64 / 400.0;
            let d = c.eval(t).distance(at);
            if d < best.0 {
                best = (d, t);
            }
        }
        let mut reach = 1.0 / 400.0;
        while reach > 1e-12 {
            for side in [-1.0, 1.0] {
                let t: f64 = (best.1 + side * reach / 2.0f64).max(0.0).min(1.0);
                let d = c.eval(t).distance(at);
                if d < best.0 {
                    best = (d, t);
                }
            }
            reach *= 0.7;
        }
        least = least.min(best.0);
    }
    least
}

fn measure(mut call: impl FnMut()) -> (f64, f64) {
    let begin = Instant::now();
    let mut runs = Vec::new();
    while runs.len() < 5 || (begin.elapsed().as_secs_f64() < 0.4 && runs.len() < 400) {
        let start = Instant::now();
        call();
        runs.push(start.elapsed().as_secs_f64());
    }
    runs.sort_by(|a, b| a.partial_cmp(b).unwrap());
    (runs[0], runs[runs.len() / 2])
}

fn main() {
    let path = wave();
    let mut random = Random(5);
    let queries: Vec<Point> = (0..QUERIES)
        .map(|_| {
            let x = 10.0 * WAVE as f64 * random.next();
            Point::new(x, 100.0 * random.next() - 20.0)
        })
        .collect();
    let error = queries[..50].iter().map(|&q| (nearest(&path, q) - reference(&path, q)).abs()).fold(0.0, f64::max);
    let mut sink = 0.0;
    let (best, median) = measure(|| sink += queries.iter().map(|&q| nearest(&path, q)).sum::<f64>());
    assert!(sink > 0.0);
    let each = 1e6 / QUERIES as f64;
    println!(
        "{{\"program\":\"kurbo\",\"name\":\"nearest, planar cubic, n=100\",\"unit\":\"us\",\"best\":{:.4},\"median\":{:.4},\"note\":\"distances off by {:.0e}\"}}",
        best * each, median * each, error
    );
}
