// The document types of XML files: what they declare, as far as it changes what is read. Files that the page reads at once have
// none; the worker imports this.

import { character, nameEnd, skip, types } from './xml.js';

/** @typedef {import('./xml.js').Reader} Reader */

/** @param {Reader} reader @param {string} s @param {number} at @returns {number} past the spaces, of which there is one */
function space(reader, s, at) {
  const end = skip(s, at);
  reader.need(end > at);
  return end;
}

/** Where a file is, which nobody asks for. @param {Reader} reader @param {string} s @param {number} at */
function outside(reader, s, at) {
  let end = space(reader, s, at + 6);
  if (s.startsWith('PUBLIC', at)) {
    end = space(reader, s, reader.quoted(s, end)[1]);
  }
  return reader.quoted(s, end)[1];
}

/** @param {string} s @param {number} at */
function isOutside(s, at) {
  return s.startsWith('SYSTEM', at) || s.startsWith('PUBLIC', at);
}

/** <!DOCTYPE @param {Reader} reader @param {string} s @param {number} at @returns {number} past it */
function readType(reader, s, at) {
  let i = space(reader, s, at + 9);
  i = skip(s, reader.name(s, i));
  if (isOutside(s, i)) {
    i = skip(s, outside(reader, s, i));
    reader.partial = true;
  }
  if (s[i] === '[') {
    i = declarations(reader, s, i + 1, true);
    reader.need(s[i] === ']');
    i = skip(s, i + 1);
  }
  reader.need(s[i] === '>');
  return i + 1;
}

/** @param {Reader} reader @param {string} s @param {number} at @param {boolean} top not in an entity @returns {number} where they end */
function declarations(reader, s, at, top) {
  for (let i = skip(s, at); ; i = skip(s, i)) {
    reader.go(i);
    if (i >= s.length || (top && s[i] === ']')) {
      return i;
    }
    if (s[i] === '%') {
      const end = reader.name(s, i + 1);
      reader.need(s[end] === ';');
      const name = s.slice(i + 1, end);
      if (reader.parameters.get(name)?.outside) {
        reader.partial = true;
      } else {
        reader.within(name, reader.parameters, (text) => reader.need(declarations(reader, text, 0, false) === text.length));
      }
      i = end + 1;
    } else if (s.startsWith('<!--', i)) {
      i = reader.comment(s, i);
    } else if (s.startsWith('<?', i)) {
      i = reader.instruction(s, i);
    } else if (s.startsWith('<!ENTITY', i)) {
      i = entity(reader, s, i + 8);
    } else if (s.startsWith('<!ATTLIST', i)) {
      i = attributesOf(reader, s, i + 9);
    } else {
      reader.need(s.startsWith('<!ELEMENT', i) || s.startsWith('<!NOTATION', i));
      i = past(reader, s, i);
    }
  }
}

/** The end of a declaration of which nothing is needed. @param {Reader} reader @param {string} s @param {number} at */
function past(reader, s, at) {
  for (let i = at; ; i++) {
    reader.need(i < s.length);
    if (s[i] === '>') {
      return i + 1;
    }
    if (s[i] === '"' || s[i] === "'") {
      i = reader.find(s, s[i], i + 1);
    }
  }
}

/** <!ENTITY @param {Reader} reader @param {string} s @param {number} at @returns {number} past it */
function entity(reader, s, at) {
  let i = space(reader, s, at);
  const known = s[i] === '%' ? reader.parameters : reader.entities;
  i = s[i] === '%' ? space(reader, s, i + 1) : i;
  const end = reader.name(s, i);
  const name = s.slice(i, end);
  const made = { text: '', outside: false };
  i = space(reader, s, end);
  if (isOutside(s, i)) {
    made.outside = true;
    i = past(reader, s, outside(reader, s, i)) - 1;
  } else {
    const [raw, next] = reader.quoted(s, i);
    reader.need(!raw.includes('%'));
    made.text = raw.replace(/&([^;&]*)(;?)/g, (whole, reference, semicolon) => {
      reader.need(semicolon && (reference.startsWith('#') || (reference && nameEnd(reference, 0) === reference.length)));
      return reference.startsWith('#') ? String(reader.need(character(reference))) : whole;
    });
    i = skip(s, next);
  }
  reader.need(s[i] === '>');
  if (!known.has(name)) {
    known.set(name, made);
  }
  return i + 1;
}

/** <!ATTLIST @param {Reader} reader @param {string} s @param {number} at @returns {number} past it */
function attributesOf(reader, s, at) {
  let i = space(reader, s, at);
  let end = reader.name(s, i);
  const element = s.slice(i, end);
  const given = reader.given.get(element) ?? new Map();
  for (i = skip(s, end); s[i] !== '>'; i = skip(s, i)) {
    end = reader.name(s, i);
    const name = s.slice(i, end);
    i = space(reader, s, end);
    i = s[i] === '(' ? reader.find(s, ')', i) + 1 : reader.name(s, i);
    i = space(reader, s, i);
    if (s[i] === '(') { // of notations
      i = space(reader, s, reader.find(s, ')', i) + 1);
    }
    const fixed = s.startsWith('#FIXED', i);
    if (s[i] === '#' && !fixed) {
      i = reader.name(s, i + 1);
      continue;
    }
    const [raw, next] = reader.quoted(s, fixed ? space(reader, s, i + 6) : i);
    i = next;
    if (!given.has(name)) {
      given.set(name, reader.value(raw));
    }
  }
  reader.given.set(element, given);
  return i + 1;
}

types.read = readType;
