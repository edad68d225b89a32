// Colours of the robot in light and dark, and the scale for the share of a spring in the strain energy of a mode.
// The scale runs from grey through orange to red: its lightness is monotonic, so that it can be read without hues.

const PALETTES = {
  light: {
    background: "#f3f6f9", grid: "#cfd8e1", text: "#1d2833", ghost: "#8794a1", workspace: "#3b78b8",
    rail: "#8d98a4", carriage: "#4d6075", link: "#6b7a8a", arm: "#566a80", platform: "#1f5fa8", base: "#b3bdc8",
    wheel: "#a4b0bd", mark: "#3c4a59", gantry: "#7a8897", body: "#4d6075", trace: "#0b6e99", measured: "#a3127c", marked: "#0a8f3c",
    scale: ["#c5cdd6", "#f0b340", "#d9570d", "#7d0d0d"],
  },
  dark: {
    background: "#12181f", grid: "#2c3743", text: "#e3eaf1", ghost: "#64727f", workspace: "#6ea8e0",
    rail: "#74828f", carriage: "#9db2c8", link: "#93a3b3", arm: "#a9bacb", platform: "#5b9fe6", base: "#45515e",
    wheel: "#5d6b79", mark: "#d4dde6", gantry: "#8a99a8", body: "#9db2c8", trace: "#56c4ee", measured: "#ff8fd8", marked: "#4be07f",
    scale: ["#4a5663", "#a34d12", "#f2902c", "#ffe89a"],
  },
};
// Name of the colour in a palette for each kind of element.
const COLOUR_OF_KIND = {
  rail: "rail", frame: "base", carriage: "carriage", toolhead: "platform", bed: "platform", link: "link", arm: "arm", axle: "link", shaft: "rail",
  platform: "platform", base: "base", pulley: "wheel", idler: "wheel", motor: "wheel", reducer: "wheel",
  gantry: "gantry", body: "body",
};
// Radius of a line or ball as a share of the robot's size.
const RELATIVE_RADIUS = {
  rail: 0.0055, frame: 0.0065, link: 0.0048, arm: 0.011, axle: 0.006, shaft: 0.007, gantry: 0.009, belt: 0.0032,
  platform: 0.018, body: 0.014,
};

function rgbChannels(colour) {
  return [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
}

// Colour of a share from 0 to 1 on the scale.
function scaleColour(scale, share) {
  const position = Math.min(Math.max(share, 0), 1) * (scale.length - 1);
  const i = Math.min(Math.floor(position), scale.length - 2);
  const [low, high] = [rgbChannels(scale[i]), rgbChannels(scale[i + 1])];
  return `rgb(${low.map((v, k) => Math.round(v + (position - i) * (high[k] - v))).join(",")})`;
}
