// Sliders: each with a number beside it and a way back to the value of the spec.

const LAST = 1000;

// A number for people, in so many digits at most.
function shown(value, digits = 5) {
  if (!Number.isFinite(value)) return "none";
  const size = Math.abs(value);
  if (value !== 0 && (size < 1e-4 || size >= 1e7)) {
    return Number(value.toPrecision(digits)).toExponential().replace("e+", "e");
  }
  return String(Number(value.toPrecision(digits)));
}

class Slider {
  // `changed` is called whenever the value is another one, or what is typed is no number.
  constructor(root, changed) {
    const [range, number] = root.querySelectorAll("input");
    Object.assign(this, { root, range, number, changed, key: root.dataset.key });
    this.original = Number(root.dataset.value);
    this.value = this.original;
    this.unit = root.querySelector(".unit").textContent;
    this.isValid = true;
    this.name = root.querySelector("label code").textContent;
    this.back = root.querySelector("button");
    range.addEventListener("input", () => this.take(this.valueAt(Number(range.value)), range));
    number.addEventListener("input", () => this.take(number.value.trim() === "" ? NaN : Number(number.value), number));
    this.back.addEventListener("click", () => this.take(this.original));
    this.place();
  }

  // From a tenth to ten times a positive value, in equal factors; else twice as far to either
  // side.
  valueAt(place) {
    const share = place / LAST;
    if (2 * place === LAST) return this.original;
    if (this.original > 0) return Number((this.original * 100 ** (share - 0.5)).toPrecision(4));
    const far = this.original === 0 ? 1 : 2 * Math.abs(this.original);
    return Number((far * (2 * share - 1)).toPrecision(4));
  }

  placeOf(value) {
    const far = this.original === 0 ? 1 : 2 * Math.abs(this.original);
    const share = this.original > 0 ? 0.5 + Math.log(value / this.original) / Math.log(100) : 0.5 + value / far / 2;
    return Number.isFinite(share) ? Math.max(0, Math.min(LAST, LAST * share)) : 0;
  }

  take(value, from = null) {
    this.isValid = Number.isFinite(value);
    this.number.setAttribute("aria-invalid", String(!this.isValid));
    if (this.isValid) {
      this.value = value;
      this.place(from);
    }
    this.changed();
  }

  // Where the thumb and the number stand; what is being typed is left alone.
  place(from = null) {
    if (from !== this.range) this.range.value = this.placeOf(this.value);
    if (from !== this.number) this.number.value = String(this.value);
    this.range.setAttribute("aria-valuetext", `${shown(this.value)} ${this.unit}`.trim());
    this.root.classList.toggle("moved", this.value !== this.original);
    this.back.disabled = this.value === this.original;
  }

  reset() {
    this.value = this.original;
    this.isValid = true;
    this.number.removeAttribute("aria-invalid");
    this.place();
  }
}
