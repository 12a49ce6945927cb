// The Chinese for what the probe says of a pixel, by the English; formulas, names of numbers and materials stay as they are.
// A test looks for every verdict and answer.
import { language } from "./texts.js";

const kWords = {
  // Samples.
  "occludes": "遮挡",
  "nothing in front": "前方无物",
  "too far in front": "在前方太远",
  "too far away": "离得太远",
  "below the surface": "在表面之下",
  "in front of the near plane": "在近平面之前",
  "meets nothing": "未遇到任何物体",
  "no darker than the others": "不比其他更暗",
  // Taps of the blur, its passes and what they end with.
  "counts": "计入",
  "the texel itself": "纹素自身",
  "outside the map": "在图之外",
  "outside the box": "在方框之外",
  "no surface": "无表面",
  "the depths differ": "深度不同",
  "the normals differ": "法线不同",
  "one lies off the other's plane": "一方不在另一方的平面上",
  "an edge lies between": "中间隔着边缘",
  "no surface: 1": "无表面：1",
  "sum / total, at most 1": "sum / total，至多 1",
  "sum / total, as a 16-bit float": "sum / total，存为 16 位浮点数",
  "the texel keeps its value, for no other counts": "纹素保持原值，因为没有别的计入",
  "squares of four, across": "四个一块，横向",
  "squares of four, down": "四个一块，纵向",
  "fine, across": "最近邻，横向",
  "fine, down": "最近邻，纵向",
  // Triangles.
  "kept": "保留",
  "drawn over": "被覆盖",
  "behind": "在后面",
  "equal": "相等",
  "outside": "在外面",
  "facing away": "背向",
  "cut out": "被镂空",
  "hidden": "被遮住",
  "kept: it is what the pixel shows": "保留：像素显示的就是它",
  "drawn over: it was nearer than what was there, a later one nearer still": "被覆盖：它比原有的更近，但之后又来了更近的",
  "behind: what was there is nearer": "在后面：原有的更近",
  "equal: of equal depths the first one stays": "相等：深度相同时先到的留下",
  "facing away: back faces are culled": "背向：背面被剔除",
  "cut out: its texture has a hole here": "被镂空：其纹理在此处有孔",
  "hidden: left out as a whole, for all around there is nearer": "被遮住：整个略去，因为周围的一切都更近",
  // Light.
  "ambient": "环境光",
  "diffuse": "漫反射",
  "specular": "镜面反射",
  "diffuse and specular": "漫反射与镜面反射",
  "reflection": "反射",
  "sky": "天空",
  "sum of all terms": "各项之和",
  // What is left out.
  "the method is none: everything counts as open": "方法为 none：一切皆开放",
  "the scene has no triangles: everything is open": "场景没有三角形：一切皆开放",
  "the method has no denoiser": "该方法没有去噪",
  "blur_iterations is 0": "blur_iterations 为 0",
};

// Sentences with numbers in them, part by part.
const kSentences = [
  [/^iteration (\d+)/, "第 $1 次"],
  [/^(第 \d+ 次), across$/, "$1，横向"],
  [/^(第 \d+ 次), down$/, "$1，纵向"],
  [/^outside: the pixel's centre lies beyond edge (\d)$/, "在外面：像素中心在第 $1 条边之外"],
  [/^outside: the pixel's centre lies on edge (\d), which is neither a top nor a left edge$/, "在外面：像素中心在第 $1 条边上，而它既不是上边也不是左边"],
  [/^AO (\S+): the texel shows the background, which is open\.$/, "AO $1：纹素显示的是背景，完全开放。"],
  [/^AO (\S+): none of (\d+) samples occludes/, "AO $1：$2 个采样都不遮挡"],
  [/^AO (\S+): (\d+) of (\d+) samples? occludes?; the darkest is sample (\d+)/, "AO $1：$3 个采样中有 $2 个遮挡，取走最多的是第 $4 个"],
  [/, which stands for the texel as a whole/, "，它代表整个纹素"],
  [/ at (\(.+?\)), whose r is as far as p/, "，位于 $1，其 r 与 p 同深"],
  [/ at (\(.+?\)), whose r lies (\S+) in front of p/, "，位于 $1，其 r 在 p 前方 $2"],
  [/ at (\(.+?\)), whose r lies (\S+) behind p/, "，位于 $1，其 r 在 p 后方 $2"],
  [/\. Denoised it is (\S+); the lit pixel reads (\S+)\.$/, "。去噪后为 $1，光照像素读到 $2。"],
];

function sentenceInChinese(english) {
  // Why no AO was computed, which the answer repeats.
  const left_out = /^AO (\S+): (.+)\.$/.exec(english);
  if (left_out !== null && left_out[2] in kWords) return `AO ${left_out[1]}：${kWords[left_out[2]]}。`;
  const parts = kSentences.reduce((text, [pattern, chinese]) => text.replace(pattern, chinese), english);
  return parts === english ? english : parts.replace(/\.$/, "。");
}

// In the page's language where there is a text for it.
export const probeText = (english) => (language === "zh" ? kWords[english] ?? sentenceInChinese(english) : english);
