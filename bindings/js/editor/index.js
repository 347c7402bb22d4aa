// <batten-editor> with the editor's page inside, so that no bundler and no server has to find it.
import { define } from './element.js';
import { Inside } from './inside.js';
import packed from './page.js';

export { BattenEditor } from './element.js';

define(new Inside(packed));
