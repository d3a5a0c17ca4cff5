// The palette of Okabe and Ito, which colour-blind people tell apart; style.css has the same for light and dark.
/** `broad`: what was measured, as a broad line below a thin one. */
export type Colour = 'measured' | 'broad' | 'predicted' | 'residual' | 'floor' | 'held' | 'truth' | 'other' | 'second';

/** As the page's style has it now, for what is drawn on a canvas. */
export const colourNow = (name: string) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

const kSeries: Colour[] = ['predicted', 'residual', 'truth', 'held', 'other', 'second', 'measured'];
export const seriesColour = (index: number): Colour => kSeries[index % kSeries.length];
