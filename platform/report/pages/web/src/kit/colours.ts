// The palette of Okabe and Ito, which colour-blind people tell apart; style.css has the same for light and dark.
export type Colour = 'measured' | 'predicted' | 'residual' | 'floor' | 'held' | 'truth' | 'other' | 'second';

/** As the page's style has it now, for what is drawn on a canvas. */
export const colourNow = (name: string) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

const kSeries: Colour[] = ['predicted', 'residual', 'truth', 'held', 'other', 'second', 'measured'];
export const seriesColour = (index: number): Colour => kSeries[index % kSeries.length];
