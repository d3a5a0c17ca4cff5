import { render } from 'preact';
import { openSource } from './data/open';
import { App } from './app';

const page = document.getElementById('page')!;
const say = (text: string) => {
  const line = document.createElement('p');
  line.className = 'error';
  line.textContent = text;
  page.replaceChildren(line);
};

openSource().then(
  (source) => render(<App source={source} />, page),
  (error: Error) =>
    say(`Cannot open the data of this report: ${error.message}. Use a browser of 2023 or later.`),
);
