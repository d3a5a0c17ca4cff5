/** A word as a shell takes it, like foundation/text/shell_word. */
export const shellWord = (word: string) =>
  /^[A-Za-z0-9_./=:@%+,-]+$/.test(word) ? word : `'${word.replace(/'/g, `'\\''`)}'`;
