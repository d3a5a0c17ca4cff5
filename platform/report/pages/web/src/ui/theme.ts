import { useLayoutEffect, useState } from 'preact/hooks';
import { whenPrinted } from '../kit/paper';

const kThemes = ['auto', 'light', 'dark'] as const;
type Theme = (typeof kThemes)[number];

/** A page from disk may not be allowed to remember anything. */
function remembered(): Theme {
  try {
    const theme = localStorage.getItem('lacuna-theme') as Theme;
    return kThemes.includes(theme) ? theme : 'auto';
  } catch {
    return 'auto';
  }
}

function remember(theme: Theme): void {
  try {
    localStorage.setItem('lacuna-theme', theme);
  } catch {
    /* it is asked again next time */
  }
}

function paint(palette: 'light' | 'dark'): void {
  if (document.documentElement.dataset.theme === palette) return;
  document.documentElement.dataset.theme = palette;
  dispatchEvent(new Event('lacuna-theme'));
}

/** Paper is light, whatever was chosen. Returns what ends it. */
function follow(theme: Theme): () => void {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const show = () => paint(theme === 'dark' || (theme === 'auto' && system.matches) ? 'dark' : 'light');
  show();
  system.addEventListener('change', show);
  const unprinted = whenPrinted(() => paint('light'), show);
  return () => {
    system.removeEventListener('change', show);
    unprinted();
  };
}

export function useTheme(): [Theme, () => void] {
  const [theme, setTheme] = useState<Theme>(remembered);
  useLayoutEffect(() => {
    remember(theme);
    return follow(theme);
  }, [theme]);
  return [theme, () => setTheme(kThemes[(kThemes.indexOf(theme) + 1) % kThemes.length])];
}
