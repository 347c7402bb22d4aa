// <batten-editor> without a page inside: its attribute `page` says where the folder `page` of this package is served.
import { define } from './element.js';

export { BattenEditor } from './element.js';

define(null);
