// Every text of the page, English and Chinese. What comes from the tables of the program (names, effects, messages) is as
// the terminal has it.

const kTexts = {
  title: ["The lab", "实验台"],
  intro: ["Every pass of the frame, computed in this page: the same bits as <code>crevice render</code>. Drag to turn, scroll to zoom, click a pixel to ask why it is as it is.",
    "这一帧的每个通道都在本页计算，与 <code>crevice render</code> 逐位相同。拖动以旋转，滚轮缩放，点击像素查问其值的由来。"],
  scene: ["scene", "场景"],
  preset: ["preset", "预设"],
  size: ["size", "尺寸"],
  method: ["method", "方法"],
  show: ["shows", "显示"],
  against: ["against", "对比"],
  view: ["view", "视图"],
  view_one: ["one buffer", "单个缓冲"],
  view_pair: ["side by side", "并排"],
  view_split: ["split by a slider", "滑块分界"],
  view_difference: ["difference", "差值"],
  view_flip: ["flip", "翻转"],
  flip: ["flip (space)", "翻转（空格）"],
  edge: ["edge between the two", "两者的分界"],
  colours: ["colours", "配色"],
  colours_own: ["the buffer's own", "缓冲自身"],
  colours_grey: ["grey", "灰度"],
  colours_false: ["false colour", "伪彩色"],
  range_low: ["from", "从"],
  range_high: ["to", "到"],
  range_auto: ["whole range", "全范围"],
  histogram: ["how often which values stand in the buffer, heights as square roots", "缓冲中各值出现的频度（高度取平方根）"],
  picture: ["Picture: drag or use the arrow keys to turn, w a s d q e to move, + and - to zoom, 0 for the scene's own camera, space to flip", "画面：拖动或方向键旋转，w a s d q e 移动，+ 与 - 缩放，0 恢复场景相机，空格翻转"],
  camera: ["camera", "相机"],
  camera_orbit: ["orbit the target", "环绕目标"],
  camera_fly: ["look around", "自由环视"],
  camera_reset: ["the scene's own", "场景自带"],
  camera_keys: ["Keys on the picture: arrows turn, w a s d q e move, + and − zoom, 0 resets. Fingers: one turns, two move and zoom. With shift, the mouse moves.",
    "画面上的按键：方向键旋转，w a s d q e 移动，+ 与 − 缩放，0 复位。触摸：单指旋转，双指移动与缩放。按住 shift 拖动则平移。"],
  part_method: ["parameters of the method", "方法的参数"],
  part_denoiser: ["blur", "模糊"],
  part_buffers: ["buffers", "缓冲"],
  part_light: ["light", "光照"],
  all_defaults: ["all as the method has them", "全部恢复默认"],
  link: ["this picture again", "重现此画面"],
  copy_link: ["copy link", "复制链接"],
  copy_command: ["copy as command", "复制为命令"],
  copied: ["copied", "已复制"],
  pixel: ["why is this pixel as it is?", "这个像素为何如此？"],
  pixel_ask: ["ask", "查问"],
  pixel_clear: ["none", "取消"],
  pixel_hint: ["Click the picture, or give column and row. A row of a table lights its sample up; a click on it steps there.", "点击画面，或输入列与行。指向表中一行，对应采样即高亮；点击则步进到该处。"],
  sum_so_far: ["sum of the first {done} of {all}: {sum}", "前 {done} 项（共 {all} 项）之和：{sum}"],
  cut: ["cut through the depth buffer: p green, samples that take light away red, others blue, away from the eye to the right", "深度缓冲的剖面：p 为绿色，遮挡的采样为红色，其余为蓝色，向右远离观察点"],
  step: ["step", "步"],
  play: ["go on by itself", "自动步进"],
  step_first: ["before the first", "回到开始"],
  step_back: ["one back", "后退一步"],
  step_on: ["one on", "前进一步"],
  truth: ["truth by rays", "射线真值"],
  truth_cast: ["cast rays that ask what the method asks", "投射与方法同一问题的射线"],
  truth_told: ["{rays} rays a pixel: RMSE {rmse}, bias {bias} over the surfaces; the frame takes {ms} ms", "每像素 {rays} 条射线：表面上 RMSE {rmse}，偏差 {bias}；本帧 {ms} ms"],
  files: ["your own scene", "自己的场景"],
  files_hint: ["Drop an OBJ with its MTL files and textures anywhere on the page, or choose them. Nothing leaves this page.", "把 OBJ 及其 MTL、纹理拖到页面任意处，或在此选择。文件不会离开本页。"],
  no_obj: ["no OBJ among these files; drop one with its MTL files and textures", "其中没有 OBJ 文件；请连同 MTL 与纹理一起拖入"],
  passes: ["time of each pass", "各通道耗时"],
  pass: ["pass", "通道"],
  unchanged: ["unchanged", "未变"],
  buffers: ["buffers", "缓冲"],
  buffer: ["buffer", "缓冲"],
  least: ["min", "最小"],
  mean: ["mean", "平均"],
  most: ["max", "最大"],
  hash: ["hash, as in passes.json", "哈希（同 passes.json）"],
  starting: ["starting …", "启动中……"],
  drawing: ["drawing …", "绘制中……"],
  no_difference: ["these two cannot be subtracted: one has more components than the other", "二者无法相减：分量数不同"],
  nothing_to_show: ["the method has no such buffer", "该方法没有这个缓冲"],
  needs: ["The lab needs what this browser lacks:", "此浏览器缺少实验台所需的功能："],
  needs_webassembly: ["WebAssembly", "WebAssembly"],
  needs_vectors: ["WebAssembly with SIMD (Chrome 91, Firefox 89, Safari 16.4 or newer)", "带 SIMD 的 WebAssembly（Chrome 91、Firefox 89、Safari 16.4 或更新）"],
  needs_exceptions: ["WebAssembly with exceptions (Chrome 95, Firefox 100, Safari 15.2 or newer)", "带异常处理的 WebAssembly（Chrome 95、Firefox 100、Safari 15.2 或更新）"],
  needs_workers: ["web workers", "Web Worker"],
  needs_gzip: ["DecompressionStream (Chrome 80, Firefox 113, Safari 16.4 or newer)", "DecompressionStream（Chrome 80、Firefox 113、Safari 16.4 或更新）"],
};

export let language = "en";

export function translated(key) {
  return kTexts[key][language === "zh" ? 1 : 0];
}

// Texts stand in [data-text], what a screen reader is told in [data-label].
export function setLanguage(next) {
  language = next;
  const root = document.documentElement;
  root.lang = root.dataset.lang = next;
  for (const place of document.querySelectorAll("[data-text]")) place.innerHTML = translated(place.dataset.text);
  for (const place of document.querySelectorAll("[data-label]")) place.setAttribute("aria-label", translated(place.dataset.label));
  for (const button of document.querySelectorAll("[data-set-lang]"))
    button.setAttribute("aria-pressed", String(button.dataset.setLang === next));
  try { localStorage.setItem("crevice-language", next); } catch { /* some browsers keep nothing for files */ }
}

// What the address asks for, what was chosen last in the book or here, or what the browser speaks.
export function firstLanguage(asked) {
  let kept = null;
  try { kept = localStorage.getItem("crevice-language"); } catch { /* as above */ }
  return [asked, kept, navigator.language.slice(0, 2)].find((word) => word === "en" || word === "zh") ?? "en";
}
