import { useEffect, useState } from 'preact/hooks';

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

export function useTheme(): [Theme, () => void] {
  const [theme, setTheme] = useState<Theme>(remembered);
  useEffect(() => {
    document.documentElement.dataset.theme = theme;
    try {
      localStorage.setItem('lacuna-theme', theme);
    } catch {
      /* it is asked again next time */
    }
    dispatchEvent(new Event('lacuna-theme'));
    const system = matchMedia('(prefers-color-scheme: dark)');
    const changed = () => dispatchEvent(new Event('lacuna-theme'));
    system.addEventListener('change', changed);
    return () => system.removeEventListener('change', changed);
  }, [theme]);
  return [theme, () => setTheme(kThemes[(kThemes.indexOf(theme) + 1) % kThemes.length])];
}
