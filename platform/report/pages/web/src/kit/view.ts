/** `all`: also what is out of sight is wanted, at once. */
type Listener = (all: boolean) => void;

/** The stretch of time that several pictures show together. */
export class View {
  private from: number;
  private to: number;
  private listeners = new Set<Listener>();
  private waiting = false;

  /** `first` and `last`: all that there is. */
  constructor(
    readonly first: number,
    readonly last: number,
    from = first,
    to = last,
  ) {
    this.from = from;
    this.to = to;
  }

  get range(): [number, number] {
    return [this.from, this.to];
  }
  get whole(): boolean {
    return this.from <= this.first && this.to >= this.last;
  }

  /** Pictures are told once a frame, however often this is called. */
  set(from: number, to: number): void {
    const all = this.last - this.first;
    const span = Math.min(Math.max(to - from, all * 1e-7), all);
    this.from = Math.min(Math.max(from, this.first), this.last - span);
    this.to = this.from + span;
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      for (const listener of this.listeners) listener(false);
    });
  }

  /** Every picture is drawn as it is now, before all of them are kept together. */
  complete(): void {
    for (const listener of this.listeners) listener(true);
  }

  /** By a share of what is seen. */
  pan(share: number): void {
    const shift = share * (this.to - this.from);
    this.set(this.from + shift, this.to + shift);
  }

  /** `centre`: a time; the middle if none is given. */
  zoom(factor: number, centre = (this.from + this.to) / 2): void {
    this.set(centre - (centre - this.from) * factor, centre + (this.to - centre) * factor);
  }

  reset(): void {
    this.set(this.first, this.last);
  }

  listen(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
