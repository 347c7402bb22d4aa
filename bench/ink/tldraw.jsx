import { createRoot } from 'react-dom/client';
import { Tldraw } from 'tldraw';
import 'tldraw/tldraw.css';

const draw = (editor) => {
  globalThis.draw = () => editor.setCurrentTool('draw');
};
createRoot(document.body.firstChild).render(<Tldraw onMount={draw} />);
