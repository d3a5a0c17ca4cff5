/** A moment of a replay that pictures follow. */
export class Moment {
  private now = 0;
  private listeners = new Set<() => void>();

  get time(): number {
    return this.now;
  }

  set(time: number): void {
    this.now = time;
    for (const listener of this.listeners) listener();
  }

  listen(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
