// Small parts that panels are made of.

/** An element, with attributes and what is in it. */
export function element(tag, attributes = {}, ...content) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name in made && name !== "list") made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...content.filter((part) => part !== undefined));
  return made;
}

/**
 * A slider with its name and its value in words; a double click sets it back.
 * @param {{ id: string, title: string, least: number, most: number, scale?: "even" | "logarithmic", zero?: boolean,
 *   words: (value: number) => string, change: (value: number) => void, usual: () => number }} about `zero`: whether the
 *   lowest place of a logarithmic one means 0
 */
export function slider({ id, title, least, most, scale = "even", zero = false, words, change, usual }) {
  const isLogarithmic = scale === "logarithmic";
  const places = 1000;
  const toValue = (place) => {
    if (!isLogarithmic) return least + ((most - least) * place) / places;
    if (zero && place === 0) return 0;
    return Number((least * (most / least) ** (place / places)).toPrecision(3));
  };
  const toPlace = (value) => {
    const part = isLogarithmic ? Math.log(Math.max(value, least) / least) / Math.log(most / least) : (value - least) / (most - least);
    return Math.round(places * Math.max(0, Math.min(1, part)));
  };
  const output = element("output", { id: `${id}-value` });
  const input = element("input", {
    type: "range", id, min: 0, max: places, step: 1,
    oninput: () => change(toValue(Number(input.value))),
    ondblclick: () => change(usual()),
  });
  input.title = "double click: as in the scene";
  const row = element("label", { className: "slider", htmlFor: id }, element("span", {}, title), output, input);
  return {
    row, input,
    show(value) {
      if (document.activeElement !== input || toPlace(value) !== Number(input.value)) input.value = toPlace(value);
      input.style.setProperty("--part", `${toPlace(value) / 10}%`);
      output.textContent = words(value);
      input.setAttribute("aria-valuetext", words(value));
    },
    enable(isEnabled) {
      input.disabled = !isEnabled;
      row.classList.toggle("off", !isEnabled);
    },
  };
}
