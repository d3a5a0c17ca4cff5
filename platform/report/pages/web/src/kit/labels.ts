/** Names of limited room: broken into lines and, where even these are too long, shortened so that names that differ still
 *  look different. */

const lcp = (a: string, b: string) => {
  let i = 0;
  while (i < a.length && i < b.length && a[i] === b[i]) ++i;
  return i;
};

const short = (name: string, others: string[], letters: number): string => {
  if (name.length <= letters) return name;
  const differs = Math.max(0, ...others.filter((one) => one !== name).map((one) => lcp(name, one)));
  const head = Math.ceil((letters - 1) / 2);
  if (differs < head) return `${name.slice(0, head)}…${name.slice(name.length - (letters - 1 - head))}`;
  const begin = Math.floor(letters / 3);
  const window = letters - begin - 2;
  const from = Math.min(Math.max(differs - 2, begin), name.length - window);
  const end = from + window < name.length ? '…' : '';
  return `${name.slice(0, begin)}…${name.slice(from, from + window)}${end}`;
};

/** Each name in at most so many letters, with its begin and the part that tells it from the others. Names that would come
 *  to the same stay whole. */
export function shortened(names: string[], letters: number): string[] {
  const texts = names.map((one) => short(one, names, letters));
  const meant = new Map<string, Set<string>>();
  texts.forEach((text, i) => meant.set(text, (meant.get(text) ?? new Set()).add(names[i])));
  return texts.map((text, i) => (meant.get(text)!.size > 1 ? names[i] : text));
}

/** Lines of at most so many letters that end behind a space, or in a long word behind "_", "." or "·", where that is
 *  possible. */
export function wrapped(name: string, letters: number): string[] {
  const lines: string[] = [];
  const put = (part: string): boolean => {
    const last = lines[lines.length - 1];
    const joins = last !== undefined && (last + part).trimEnd().length <= letters;
    if (joins) lines[lines.length - 1] = last + part;
    else if (part.trimEnd().length <= letters) lines.push(part);
    else return false;
    return true;
  };
  for (const word of name.match(/[^ ]* *|/g) ?? [])
    if (word !== '' && !put(word))
      for (const part of word.match(/[^_.·]*[_.· ]*/g) ?? []) {
        if (part === '' || put(part)) continue;
        for (let at = 0; at < part.length; at += letters) lines.push(part.slice(at, at + letters));
      }
  return lines.length > 0 ? lines.map((one) => one.trimEnd()) : [''];
}

/** Each name in at most about so many lines. */
export const labelLines = (names: string[], letters: number, lines: number): string[][] =>
  shortened(names, Math.floor(0.8 * letters * lines)).map((one) => wrapped(one, letters));
