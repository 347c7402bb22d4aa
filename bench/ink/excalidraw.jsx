import { Excalidraw } from '@excalidraw/excalidraw';
import '@excalidraw/excalidraw/index.css';
import { createRoot } from 'react-dom/client';

const draw = (api) => {
  globalThis.draw = () => api.setActiveTool({ type: 'freedraw' });
};
createRoot(document.body.firstChild).render(<Excalidraw excalidrawAPI={draw} />);
