const kTyping = /^(text|search|number|email|url|tel|password|date|time)$/;

/** Whether a key is meant for what has the focus and not for the page: every key in a field for text and in a list, the
 *  space bar on a button. A slider leaves all keys to the page. */
export function isTaken(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return true;
  const focused = event.target as HTMLElement;
  if (/^(TEXTAREA|SELECT)$/.test(focused.tagName) || focused.isContentEditable) return true;
  if (focused instanceof HTMLInputElement) {
    if (kTyping.test(focused.type)) return true;
    return focused.type !== 'range' && /^( |Enter|Arrow\w+)$/.test(event.key);
  }
  return /^(BUTTON|SUMMARY)$/.test(focused.tagName) && /^( |Enter)$/.test(event.key);
}
