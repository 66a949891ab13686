const table = new Uint8Array(128).fill(255);
"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/".split("").forEach((letter, value) => {
  table[letter.charCodeAt(0)] = value;
});

/** The bytes of a base64 text. By hand, because atob makes a string of tens of megabytes first. Space around the text is fine. */
export function decodeBase64(text: string): Uint8Array<ArrayBuffer> {
  const trimmed = text.trim();
  const letters = trimmed.endsWith("==") ? trimmed.length - 2 : trimmed.endsWith("=") ? trimmed.length - 1 : trimmed.length;
  const bytes = new Uint8Array(Math.floor((letters * 3) / 4));
  let bits = 0;
  let pending = 0;
  let at = 0;
  for (let index = 0; index < letters; ++index) {
    const code = trimmed.charCodeAt(index);
    const value = code < 128 ? table[code]! : 255;
    if (value === 255) throw new Error("a block of this page is damaged: it is not base64");
    pending = ((pending << 6) | value) & 0xffffff;
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes[at++] = (pending >> bits) & 255;
    }
  }
  return bytes;
}
