// Two pictures of one frame, divided by a slider, in one view that is zoomed and moved for both.
class Comparer {
  constructor(root) {
    this.canvas = root.querySelector("canvas");
    this.slider = root.querySelector("input");
    this.view = {scale: 1, x: 0, y: 0};  // picture pixels at the canvas's corner, and canvas pixels per picture pixel
    this.images = {};
    this.slider.addEventListener("input", () => this.draw());
    this.canvas.addEventListener("wheel", event => this.zoom(event), {passive: false});
    this.canvas.addEventListener("pointerdown", event => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener("pointermove", event => this.move(event));
  }

  // left, right, reference: data URLs; with `difference`, the right side shows its distance from the reference.
  async show(left, right, reference, difference) {
    const [a, b, c] = await Promise.all([left, right, reference].map(url => this.load(url)));
    this.left = a;
    this.right = difference ? this.errorMap(b, c) : b;
    if (this.canvas.width !== a.width || this.canvas.height !== a.height) {
      this.canvas.width = a.width;
      this.canvas.height = a.height;
      this.view = {scale: 1, x: 0, y: 0};
    }
    this.draw();
  }

  async load(url) {
    if (!this.images[url]) {
      const image = new Image();
      image.src = url;
      await image.decode();
      this.images[url] = image;
    }
    return this.images[url];
  }

  pixels(image) {
    const canvas = document.createElement("canvas");
    canvas.width = image.width;
    canvas.height = image.height;
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    return {canvas, context, data: context.getImageData(0, 0, image.width, image.height)};
  }

  errorMap(image, reference) {
    const shown = this.pixels(image), exact = this.pixels(reference).data.data;
    const values = shown.data.data;
    for (let i = 0; i < values.length; ++i)
      if (i % 4 !== 3) values[i] = Math.min(255, 8 * Math.abs(values[i] - exact[i]));
    shown.context.putImageData(shown.data, 0, 0);
    return shown.canvas;
  }

  draw() {
    const context = this.canvas.getContext("2d"), {width, height} = this.canvas, {scale, x, y} = this.view;
    const divide = width * this.slider.value / this.slider.max;
    context.imageSmoothingEnabled = false;
    for (const [image, from, to] of [[this.left, 0, divide], [this.right, divide, width]]) {
      context.save();
      context.beginPath();
      context.rect(from, 0, to - from, height);
      context.clip();
      context.drawImage(image, -x * scale, -y * scale, width * scale, height * scale);
      context.restore();
    }
    context.fillStyle = "#fff";
    context.fillRect(divide - 0.5, 0, 1, height);
  }

  // Canvas pixels per CSS pixel.
  ratio() { return this.canvas.width / this.canvas.clientWidth; }

  zoom(event) {
    event.preventDefault();
    const before = this.view.scale, px = event.offsetX * this.ratio(), py = event.offsetY * this.ratio();
    this.view.scale = Math.min(32, Math.max(1, before * (event.deltaY < 0 ? 1.25 : 0.8)));
    this.view.x += px / before - px / this.view.scale;
    this.view.y += py / before - py / this.view.scale;
    this.keepInside();
  }

  move(event) {
    if (event.buttons !== 1) return;
    this.view.x -= event.movementX * this.ratio() / this.view.scale;
    this.view.y -= event.movementY * this.ratio() / this.view.scale;
    this.keepInside();
  }

  keepInside() {
    const {scale} = this.view, {width, height} = this.canvas;
    this.view.x = Math.min(Math.max(0, this.view.x), width - width / scale);
    this.view.y = Math.min(Math.max(0, this.view.y), height - height / scale);
    this.draw();
  }
}
