// A line that is said and goes away.

let timer;

export function toast(words, isWrong = false) {
  const place = document.getElementById("toast");
  place.textContent = words;
  place.className = isWrong ? "wrong shown" : "shown";
  clearTimeout(timer);
  timer = setTimeout(() => (place.className = ""), isWrong ? 9000 : 3500);
}
