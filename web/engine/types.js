// Types of the data passed between the engine and the shell; include/batten/frame.h documents their meaning.

/**
 * @typedef {object} Pointer one sample of a pen, a mouse or a finger
 * @property {number} phase
 * @property {number} device
 * @property {number} contact
 * @property {number} buttons
 * @property {number} modifiers
 * @property {number} x view pixels
 * @property {number} y
 * @property {number} pressure 0..1
 * @property {number} tiltX degrees
 * @property {number} tiltY
 * @property {number} twist
 * @property {number} width of the contact, view pixels
 * @property {number} height
 * @property {number} time milliseconds
 * @property {boolean} predicted
 */

/**
 * @typedef {object} Item something to paint; coordinates relative to the frame's origin
 * @property {number} id 0: do not cache
 * @property {number} version
 * @property {number} role
 * @property {number} flags
 * @property {number} stroke 0xRRGGBBAA
 * @property {number} fill
 * @property {number} width
 * @property {number} opacity
 * @property {number} cap
 * @property {number} join
 * @property {number} miterLimit
 * @property {number} x0
 * @property {number} y0
 * @property {number} x1
 * @property {number} y1
 * @property {Float32Array} path a view into the module's memory
 * @property {Float32Array | null} paint gradients, dashes and the pen; null: a style is all
 * @property {number} picture number of an image's picture: equal numbers mean the same picture
 */

/**
 * @typedef {object} Label a short text with live values, drawn above the overlay
 * @property {number} role
 * @property {number} x relative to the frame's origin
 * @property {number} y
 * @property {number} dx view pixels from there to the centre of the text
 * @property {number} dy
 * @property {number} turn degrees, about the centre of the text
 * @property {string} text
 */

/**
 * @typedef {object} Frame
 * @property {number} x screen = (document - (x, y)) * zoom, turned by the angle
 * @property {number} y
 * @property {number} zoom
 * @property {number} angle degrees, clockwise
 * @property {number} jumps of the view so far
 * @property {number} tilt degrees that the page lies back: 0 face-on
 * @property {boolean} surfaces some are shown
 * @property {string} offer the command that the notice offers, "" for none
 * @property {number} originX
 * @property {number} originY
 * @property {number} stillVersion
 * @property {boolean} stillChanged
 * @property {Item[]} still back to front
 * @property {[number, number, number, number]} dirty x0 > x1: nothing
 * @property {Item[]} live
 * @property {Label[]} labels
 * @property {number} cursor
 * @property {number} revision grows with every change of the document
 * @property {number} selection grows with every change of the selection
 * @property {number} selected
 * @property {number} layer the active one; 0: none
 * @property {number} readings changes with the last stroke's readings; 0: none
 * @property {number} levels changes when the level strip shows something else; 0: no strip
 * @property {number} moves changes when the time strip shows something else; 0: no strip
 * @property {number} lost number of things that overwriting the file would lose
 * @property {number} first bits: first-use hints to show
 * @property {number} requests
 * @property {boolean} unsaved
 * @property {boolean} canUndo
 * @property {boolean} canRedo
 * @property {number} tool
 * @property {number} knotsBefore
 * @property {number} knotsAfter
 * @property {number} pending 1: a fit awaits a yes or a no; 2: an object is being made until a yes; 0: neither
 * @property {boolean} busy a stroke or a drag is under way
 * @property {number} error of the fit shown, document units; 0: no fit
 * @property {number} tolerance document units
 * @property {string} hint
 * @property {string} notice
 * @property {number} noticeVersion grows with every notice
 * @property {string} name
 */

/**
 * @typedef {object} CommandRow
 * @property {string} name
 * @property {string} label
 * @property {string} help
 * @property {string[]} keys
 * @property {string} section key of its heading
 *
 * @typedef {object} PropertyRow
 * @property {string} name
 * @property {'number' | 'switch' | 'colour' | 'choice'} type
 * @property {string} group
 * @property {string} subject key of the heading it belongs to
 * @property {string[]} [choices]
 * @property {string} label
 * @property {string} help
 * @property {number} default
 * @property {number} low
 * @property {number} high
 * @property {number} step
 * @property {string} unit
 *
 * @typedef {object} ToolRow
 * @property {string} name
 * @property {string} command
 * @property {string[]} keys
 * @property {string} label
 * @property {string} help
 *
 * @typedef {object} Tables
 * @property {CommandRow[]} commands
 * @property {PropertyRow[]} properties
 * @property {ToolRow[]} tools
 * @property {string[]} numbers names of the numbers that can be entered
 * @property {Record<string, string>} strings
 */

export {};
