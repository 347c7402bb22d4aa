/** What a `save` event tells. */
export interface Saving {
  /** The file: SVG that keeps every knot, or JSON when the drawing is a `.batten` file. */
  text: string;
  name: string;
  /** Media type. */
  type: string;
  /** Takes the file over. The editor says so and calls the drawing saved when the promise is fulfilled; when it is
   * rejected, the editor shows the reason and the drawing stays unsaved. */
  waitUntil(stored: Promise<unknown>): void;
}

export interface BattenEditorEvents {
  /** The editor shows a drawing; again whenever the element was removed and put back. */
  ready: CustomEvent<{ svg: string }>;
  /** The user has changed the drawing: soon after each step, undo and saving among them. */
  change: CustomEvent<{ svg: string }>;
  /** The user saves. Unless `waitUntil` or `preventDefault` is called, the file is downloaded. */
  save: CustomEvent<Saving>;
  /** A drawing could not be opened, or no editor is at `page`. */
  error: CustomEvent<{ message: string }>;
}

export class BattenEditor extends HTMLElement {
  /** Address of the drawing: SVG or another file that the editor reads. Setting it opens that; see `load`. '': none. */
  src: string;
  /** Address of the folder `page` of this package; '': beside the script. */
  page: string;
  /** The drawing as SVG, as of the last `ready` or `change`. It stays when the element is removed. */
  readonly svg: string;
  /** Whether anything was drawn since the drawing was opened or saved. */
  readonly unsaved: boolean;
  /** Opens a drawing: true when it is open. If what is open is unsaved, the user is asked first, and may refuse.
   * `name`: its end tells the kind, `.svg` by default. It waits until the element is in a page. */
  load(content: string | Uint8Array | ArrayBuffer, name?: string): Promise<boolean>;
  /** The drawing as SVG as it is now, the last step included. */
  read(): Promise<string>;
  /** Saves as the editor's command does: `save` follows. */
  save(): Promise<void>;
  addEventListener<K extends keyof BattenEditorEvents>(type: K, listener: (this: BattenEditor, event: BattenEditorEvents[K]) => unknown, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject | null, options?: boolean | AddEventListenerOptions): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'batten-editor': BattenEditor;
  }
}
