// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A plot of a few series over time, with a cursor; a click goes to that time. Own canvas code: two plots need less
// than a library brings.

const kLeft = 58, kBottom = 16, kTop = 16;

function short(value) {
    const size = Math.abs(value);
    const [unit, name] = size >= 1e9 ? [1e9, 'G'] : size >= 1e6 ? [1e6, 'M'] : size >= 1e4 ? [1e3, 'k'] : [1, ''];
    return Number((value / unit).toPrecision(3)).toString() + name;
}

// Each pixel column shows the lowest and highest value that falls into it, so that no peak is lost.
function columns_of(times, values, start, end, width) {
    const low = new Float32Array(width).fill(NaN), high = new Float32Array(width).fill(NaN);
    for (let i = 0; i < times.length; ++i) {
        const column = Math.min(width - 1, Math.floor((times[i] - start) / (end - start) * width));
        if (column < 0 || !Number.isFinite(values[i])) continue;
        if (!(low[column] <= values[i])) low[column] = values[i];
        if (!(high[column] >= values[i])) high[column] = values[i];
    }
    return {low, high};
}

export class Plot {
    // series: [{name, color, values}]; without seek a click does nothing
    constructor(canvas, times, series, unit, seek) {
        Object.assign(this, {canvas, unit});
        this.show(times, series);
        if (seek) this.listen(seek);
    }

    show(times, series) {
        Object.assign(this, {times, series, back: null});
        this.start = times[0] ?? 0;
        this.end = Math.max(times[times.length - 1] ?? 0, this.start + 1e-9);
        let low = Infinity, high = -Infinity;
        for (const {values} of series) {
            for (const value of values) {
                if (!Number.isFinite(value)) continue;
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
        }
        if (!(low <= high)) low = high = 0;
        const pad = 0.06 * (high - low) || Math.max(1e-9, 0.1 * Math.abs(high));
        this.low = low >= 0 && low < 0.3 * high ? 0 : low - pad;
        this.high = high + pad;
    }

    listen(seek) {
        const {canvas} = this, at = event => {
            const box = canvas.getBoundingClientRect();
            const part = (event.clientX - box.left - kLeft) / (box.width - kLeft);
            seek(this.start + Math.min(1, Math.max(0, part)) * (this.end - this.start));
        };
        canvas.addEventListener('pointerdown', event => {
            canvas.setPointerCapture(event.pointerId);
            at(event);
        });
        canvas.addEventListener('pointermove', event => { if (event.buttons & 1) at(event); });
    }

    resize() {
        const ratio = window.devicePixelRatio || 1, box = this.canvas.getBoundingClientRect();
        this.canvas.width = Math.round(box.width * ratio);
        this.canvas.height = Math.round(box.height * ratio);
        this.back = null;
    }

    x(time) { return kLeft + (time - this.start) / (this.end - this.start) * (this.width - kLeft); }
    y(value) { return kTop + (this.high - value) / (this.high - this.low) * (this.height - kTop - kBottom); }

    paint(context) {
        const style = getComputedStyle(this.canvas);
        context.font = '11px system-ui, sans-serif';
        context.fillStyle = context.strokeStyle = style.color;
        context.textAlign = 'right';
        for (const value of [this.low, (this.low + this.high) / 2, this.high]) {
            const y = this.y(value);
            context.globalAlpha = 0.2;
            context.fillRect(kLeft, y, this.width - kLeft, 1);
            context.globalAlpha = 0.8;
            context.fillText(short(value), kLeft - 4, y + 4);
        }
        context.textAlign = 'left';
        context.fillText(`${this.start.toFixed(1)} s`, kLeft, this.height - 3);
        context.textAlign = 'right';
        context.fillText(`${this.end.toFixed(2)} s`, this.width - 2, this.height - 3);
        context.textAlign = 'left';
        context.globalAlpha = 1;
        let x = kLeft;
        for (const {name, color} of this.series) {
            context.fillStyle = color;
            const label = `${name} (${this.unit})`;
            context.fillText(label, x, 11);
            x += context.measureText(label).width + 12;
        }
        for (const one of this.series) this.curve(context, one);
    }

    curve(context, {color, values}) {
        const width = Math.max(1, Math.floor(this.width - kLeft));
        const {low, high} = columns_of(this.times, values, this.start, this.end, width);
        context.strokeStyle = color;
        context.lineWidth = 1.5;
        context.beginPath();
        let drawn = false;
        for (let i = 0; i < width; ++i) {
            if (Number.isNaN(low[i])) continue;
            if (!drawn) context.moveTo(kLeft + i, this.y(low[i])); else context.lineTo(kLeft + i, this.y(low[i]));
            if (high[i] !== low[i]) context.lineTo(kLeft + i, this.y(high[i]));
            drawn = true;
        }
        context.stroke();
    }

    draw(time) {
        const ratio = window.devicePixelRatio || 1, context = this.canvas.getContext('2d');
        this.width = this.canvas.width / ratio;
        this.height = this.canvas.height / ratio;
        if (!this.back) {
            this.back = document.createElement('canvas');
            this.back.width = Math.max(1, this.canvas.width);
            this.back.height = Math.max(1, this.canvas.height);
            const painted = this.back.getContext('2d');
            painted.scale(ratio, ratio);
            this.paint(painted);
        }
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, this.canvas.width, this.canvas.height);
        context.drawImage(this.back, 0, 0);
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.fillStyle = '#d0021b';
        context.fillRect(this.x(time) - 0.75, kTop - 3, 1.5, this.height - kTop - kBottom + 6);
    }
}
