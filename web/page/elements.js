// Elements as sheets make them.

/** @template {keyof HTMLElementTagNameMap} T @param {T} kind @param {string} name of its class @param {...(Node | string)} content */
export function made(kind, name, ...content) {
  const element = document.createElement(kind);
  element.className = name;
  element.append(...content);
  return element;
}
