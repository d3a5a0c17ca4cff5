// Stands for modules of Node that sql.js names but does not use in a browser.
export default {};
