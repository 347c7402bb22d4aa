// The words of calls.txt, taken apart: what a call takes, and in which order.
import { bareOf, camel } from './memory.js';
import { FLAT } from './structs.js';

/** A call as calls.txt describes it. @typedef {{ c: string, names: string[], args: [string, string][], returns: string, returned?: string }} Description */
/** An argument of C: what kind it is of, its type with and without pointers, and what its word says of it.
 * @typedef {{ word: string, type: string, bare: string, kind: string, name: string, formula?: string, missing?: string, least?: string, optional?: boolean,
 *   whole?: boolean, handed?: boolean, back?: boolean, ends?: boolean, kept?: boolean, many?: boolean }} Argument */
/** @typedef {Description & { parsed: Argument[], positional: Argument[], options: Set<string>, writes: Argument | null }} Plan */

/** A word of calls.txt, taken apart. @param {[string, string]} given the word, and the type of C @returns {Argument} */
function parse([word, type]) {
  const is = (kind, more) => ({ word, type, bare: bareOf(type), kind, ...more });
  if (/^@/.test(word)) {
    return is('self', { ends: word === '@!' });
  }
  if (word === 'dim' || word === 'null') {
    return is(word);
  }
  let match;
  if ((match = /^=(.+)/.exec(word))) {
    return is('follows', { formula: match[1] });
  }
  if ((match = /^([#%!])(\w+)/.exec(word))) {
    return is({ '#': 'count', '%': 'room', '!': 'told' }[match[1]], { name: match[2] });
  }
  if ((match = /^&(.+)/.exec(word))) {
    return { ...parse([match[1], type]), back: true };
  }
  if ((match = /^"(\w+)"(\??)/.exec(word))) {
    return is('text', { name: match[1], optional: Boolean(match[2]) });
  }
  if ((match = /^\((\w+)\)(\??)|^\{(>?)(\w+)\}/.exec(word))) {
    return is(match[1] ? 'struct' : 'options', { name: match[1] ?? match[4], back: Boolean(match[3]), optional: Boolean(match[2]) });
  }
  if ((match = /^>(\w+)(\*?)(?:\[(.*)\])?/.exec(word))) {
    return is('result', { name: match[1], handed: Boolean(match[2]), formula: match[3] });
  }
  if ((match = /^(\w+)(!?)\[(=?)(.*)\](\??)/.exec(word))) {
    return is('array', { name: match[1], kept: Boolean(match[2]), whole: Boolean(match[3]), formula: match[4], optional: Boolean(match[5]) });
  }
  match = /** @type {RegExpExecArray} */ (/^(\w+)(!?)(?:=(.+)|:(\d))?/.exec(word));
  return is('scalar', { name: match[1], kept: Boolean(match[2]), missing: match[3], least: match[4] });
}

/** What a call needs, found once. @param {Description} call @param {{ structs: Record<string, import('./memory.js').Struct>, classes: Record<string, string> }} tables @returns {Plan} */
export function prepare(call, { structs, classes }) {
  const counted = new Set(call.args.filter(([word]) => word[0] === '#').map(([word]) => word.slice(1)));
  const parsed = call.args.map((one) => parse(one)).map((arg) => ({ ...arg, many: counted.has(arg.name) }));
  const given = parsed.filter((arg) => ['scalar', 'array', 'struct', 'text'].includes(arg.kind));
  const isOptional = (arg) => arg.optional || arg.missing !== undefined;
  const fields = parsed.filter(({ kind, bare }) => kind === 'options' || FLAT.includes(bare)).flatMap(({ bare }) => structs[bare].fields.filter((field) => !field.counts));
  const makes = parsed.some(({ kind, bare }) => kind === 'result' && bare in classes);
  const written = parsed.filter(({ kind, bare, formula, handed }) => !makes && kind === 'result' && bare === 'double' && formula !== undefined && !handed);
  const options = [...given.filter(isOptional), ...fields].map(({ name }) => camel(name)).filter((name) => name !== 'size');
  return { ...call, writes: written.length === 1 ? written[0] : null, parsed, positional: given.filter((arg) => !isOptional(arg)),
    options: new Set([...options, 'dimension', ...(written.length === 1 ? ['into'] : [])]) };
}
