// A group of SVG elements that is drawn again and again. Elements keep their identity by key, so
// that focus and pointers survive a drawing.

const SVG = "http://www.w3.org/2000/svg";

export function svgElement(tag, attributes = {}, children = []) {
  const element = document.createElementNS(SVG, tag);
  setAttributes(element, attributes);
  element.append(...children);
  return element;
}

export function setAttributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined) element.removeAttribute(name);
    else if (element.getAttribute(name) !== String(value)) element.setAttribute(name, value);
  }
}

export class Layer {
  constructor(svg) {
    this.group = svg.appendChild(svgElement("g"));
    this.elements = new Map();
    this.begin();
  }

  begin() {
    this.used = new Set();
    this.next = this.group.firstChild;
  }

  /** Draw the element with this key now, above all that were drawn since begin(). */
  put(tag, key, attributes, text = null) {
    let element = this.elements.get(key);
    if (!element) {
      element = svgElement(tag);
      this.elements.set(key, element);
    }
    setAttributes(element, attributes);
    if (text !== null && element.textContent !== text) element.textContent = text;
    if (element === this.next) this.next = element.nextSibling;
    else this.group.insertBefore(element, this.next);
    this.used.add(key);
    return element;
  }

  line(key, [[x1, y1], [x2, y2]], attributes) {
    return this.put("line", key, { x1, y1, x2, y2, ...attributes });
  }

  /** Remove what was not drawn since begin(). */
  end() {
    for (const [key, element] of this.elements) {
      if (this.used.has(key)) continue;
      element.remove();
      this.elements.delete(key);
    }
  }
}
