// Style sheets for tests of several drawings in one document. Each drawing (styled_body) contains <g id="r" class="a b" lang="en">, among
// others.
#pragma once

#include <array>
#include <string>

namespace tessera::test {

/// The drawing with its sheet, for a page of 100 x 50.
inline std::string styled_body(const std::string& sheet) {
  return "<style>" + sheet + "</style><title>t</title>" +
         R"~(<defs><linearGradient id="x"><stop stop-color="#00f"/></linearGradient></defs>)~"
         R"~(<g id="r" class="a  b" data-k="v-w" xml:lang="en-GB"><rect class="c" width="20" height="20"/>)~"
         R"~(<rect id="1" x="20" width="20" height="20"/><path id="p" class="A" d="M40 0h20v20h-20z"/>)~"
         R"~(<o:odd xmlns:o="urn:o"/><rect class="d" x="60" width="20" height="20"/></g>)~"
         R"~(<a href="#x"><circle cx="20" cy="35" r="10"/></a><circle cx="50" cy="35" r="10" style="stroke:#0f0"/>)~"
         R"~(<circle class="a c" cx="80" cy="35" r="10"/>)~";
}

// clang-format off
/// Sheets that style their own drawing.
inline constexpr std::array kOwnSheets = {
    "rect{fill:red}", ".a{fill:red}", "#r{fill:red}", "#r.a.b > rect.c{fill:red}", "g rect{fill:red}", "g>*{fill:red}",
    "rect+rect{fill:red}", "rect~rect{fill:red}", "title ~ g path{fill:red}", ":root{fill:red}", "svg{fill:red}",
    "*{fill:red}", ":root > circle{fill:red}", ":scope circle{fill:red}", "g :root{fill:red}", ":not(svg):not(g){fill:red}",
    "rect:not(.c, #p){fill:red}", "rect:not(g > .c){fill:red}", ":not(:not(rect)){fill:red}", "rect:not(){fill:red}",
    "rect:first-child{fill:red}", "*:last-child{fill:red}", "circle:only-child{fill:red}", "rect:nth-child(2n+1){fill:red}",
    "rect:nth-child( 2N - 1 ){fill:red}", "rect:nth-of-type(odd){fill:red}", "rect:nth-of-type(EVEN){fill:red}",
    "rect:nth-last-of-type(-n + 2){fill:red}", "rect:nth-child(+3n){fill:red}", "rect:nth-child(n+-1){fill:red}",
    "rect:nth-child(2 n){fill:red}", "rect:nth-child(n of rect){fill:red}", "path:only-of-type{fill:red}",
    "g:empty,rect:empty{fill:red}", "a:link circle{fill:red}", "a:visited circle{fill:red}", "rect:lang(en){fill:red}",
    "rect:lang('en-gb'){fill:red}", "rect:lang(de){fill:red}", "rect:lang(fr, en){fill:red}", "[width]{fill:red}",
    "[width='20']{fill:red}", "[data-k|=v]{fill:red}", "[data-k^=v-]{fill:red}", "[data-k$='w']{fill:red}",
    "[data-k*=\"\"]{fill:red}", "[class~=b]{fill:red}", "[class=A]{fill:red}", "[class='A' i]{fill:red}",
    "[class=A s]{fill:red}", "[*|class]{fill:red}", "[|class]{fill:red}", "[x|class]{fill:red}", "[width='20'{fill:red}",
    "*|rect{fill:red}", "|rect{fill:red}", "s|rect{fill:red}", "o|odd + rect{fill:red}", "*|odd + rect{fill:red}",
    "odd + rect{fill:red}", "RECT{fill:red}", ".A{fill:red}", "#1{fill:red}", "#\\31{fill:red}", "r\\65 ct{fill:red}",
    "#\\72{fill:red}", "re/**/ct{fill:red}", "g/**/rect{fill:red}", "g /* , */ rect{fill:red}", "rect/*{*/{fill:red}",
    "&lt;!-- rect{fill:red} -->", "rect{fill:red} &lt;!--", "<![CDATA[<!-- rect{fill:red} -->]]>", "<!-- rect{fill:red} -->",
    "rect{fill:r<g>x</g>ed}", "re&#99;t{fill:red}", "rect,{fill:red}", ",rect{fill:red}", "rect,circle{fill:red}",
    "rect,:foo{fill:red}", "rect:hover{fill:red}", "rect::before{fill:red}", "rect:before{fill:red}",
    ":is(rect){fill:red}", ":where(rect){fill:red}", ":has(rect){fill:red}", "svg:has(rect) circle{fill:red}",
    ":host{fill:red}", "> rect{fill:red}", "rect >{fill:red}", "+ rect{fill:red}", "~ rect{fill:red}", "g > > rect{fill:red}",
    "*rect{fill:red}", "[width]rect{fill:red}", "g || rect{fill:red}", "g >>> rect{fill:red}", "rect!{fill:red}",
    "@media all{rect{fill:red}}", "@media all{} rect{fill:red}", "@supports (fill:red){rect{fill:red}}",
    "@layer a{rect{fill:red}}", "@scope (g){rect{fill:red}}", "@keyframes k{to{fill:red}} rect{animation:k 1s}",
    "@namespace s url(http://www.w3.org/2000/svg); s|rect{fill:red}", "@charset 'utf-8'; rect{fill:red}",
    "@foo bar; rect{fill:red}", "@foo {a;b} rect{fill:red}", "@foo rect{fill:red}", "@import 'x.css'; rect{fill:red}",
    "@font-face{font-family:x;src:url(x)} rect{fill:red}", "rect{fill:red", "rect{fill:rgb(255,0,0", "rect{fill:'", "rect{",
    "rect", "}rect{fill:red}", "){fill:blue} rect{fill:red}", "(rect{fill:blue}) circle{fill:red}", "rect{(;fill:red)}",
    "rect{fill:red;fill:foo bar}", "rect{color red;fill:red}", "rect{{fill:blue} fill:red}", "rect{x{fill:blue};fill:red}",
    "rect{@x y;fill:red}", "rect{@x{a:b} fill:red}", "rect{;;fill:red;;}", "rect{fill : red}", "rect{FILL:red}",
    "rect{fi\\6cl:red}", "rect{fill:r\\65 d}", "rect{fill:RED}", "rect{-x-fill:red}", "rect{--a:red;fill:var(--a)}",
    "rect{fill:red !important} .c{fill:blue}", "rect{fill:red!important;fill:blue!important}",
    "rect{fill:blue!important;fill:red}", "circle{stroke:red!important}", "circle{stroke:red}", ".c.c{fill:red} .c{fill:blue}",
    "#r rect{fill:red} rect.c{fill:blue}", "rect{fill:red} rect{fill:blue}", "rect:not(#z){fill:red} .c.c{fill:blue}",
    "rect{fill:url(#x)}", "rect{fill:url( '#x' )}", "rect{fill:url(\"#x\") red}", "rect{fill:url(\\23x)}",
    "rect{fill:u\\72l(#x)}", "rect{fill:url(#no) red}", "rect{fill:hsl(0,100%,50%)}", "rect{fill:rgb(255 0 0/50%)}",
    "rect{fill:red/**/}", "rect{fill:rgb/**/(255,0,0)}", "rect{fill:rgb(/**/255/**/,0,0/**/)}", "rect{fill:re/**/d}",
    "rect{stroke:lime;stroke-dasharray:5/**/3}", "rect{stroke:lime;stroke-width:1/**/0}", "rect{stroke:lime;stroke-width:5/**/px}",
    "rect{stroke:lime;stroke-width:1\\65 1}", "rect{fill:url/**/(#x) red}", "rect{fill:url(#x)/**/red}",
    "rect{fill:red//**/*;stroke:lime}", "rect:nth-child(2n/**/+1){fill:red}", "rect:nth-child(2n/**/-1){fill:red}",
    "rect:nth-child(2/**/n){fill:red}", "rect:nth-child(o/**/dd){fill:red}", "rect:nth-child(+/**/n){fill:red}",
    "rect:nth-child(n +/**/2){fill:red}", "rect{transform:translate(3px/**/,0)}",
    "rect{fill:hwb(0 0% 0%)}", "rect{fill:color(srgb 1 0 0)}", "rect{transform:translate(3px)}", "rect{filter:blur(2px)}",
    "rect{filter:opacity(.5) grayscale(1)}", "rect{opacity:calc(.5)}", "rect{fill:red}\n\n<![CDATA[circle{fill:red}]]>",
    ".c{fill:red}</style><style>rect{fill:blue}", ".c{fill:red}</style><style type='text/less'>rect{fill:blue}",
    "</style><style media='print'>rect{fill:red}", "</style><defs><style>rect{fill:red}</style></defs><style>",
    "</style><metadata><style>rect{fill:red}</style></metadata><style>",
    "</style><o:style xmlns:o='urn:o'>rect{fill:red}</o:style><style>"};

/// Selectors that would hide or move another drawing if they reached it.
inline constexpr std::array kLeavingSelectors = {
    "*", "svg", "g", "use", "html", "body", ":root", ":root *", ":root > *", "* *", "svg > *", "svg svg", ":scope", ":scope *",
    "> *", "+ *", "~ *", "~ * *", "+ * *", "> * *", "~g", "+g", "~svg", "x,~ * *", "x,+ *", "~ *,x", "x,> *", "x, ~ *, y",
    " ~ * *", "\n~ * *", "/**/~ * *", "/*x*/ ~ /*y*/ * *", "~/**/*", "\\7e * *", "\\7e  *", "\\2a", "\\2a  \\2a", "\\+ *",
    "g ~ *", "#s ~ *", "#s + *", "#s-z ~ *", "#\\73 ~ *", "[id=s] ~ *", "[id] ~ *", "[id^=s] ~ * *", "#s", "#t", "#t *", "[id=t]",
    "[id=t] *", "#n", "[id|=s]", "[id|=n]", ".n", ".n *", ".a", "*|*", "|*", "*|svg", "*|* ~ *|*", ":not(x)", ":not(#s)",
    ":not(#s *)", ":not(#s):not(#s *)", ":not(:root)", ":is(*)", ":is(~ *)", ":where(*)", ":where(:root, *)", ":has(*)",
    ":has(~ *)", ":has(+ *) ~ *", "* :has(*)", ":root:has(#s)", ":host", ":host *", ":host-context(*)", "::slotted(*)",
    ":nth-child(n)", ":nth-child(n of *)", ":nth-last-child(n)", ":first-child", ":last-child ~ *", ":empty", ":link",
    ":any-link", ":hover", ":target", ":lang(en)", ":defined", ":only-child", "::before", "*::after", "::part(x)",
    "* || *", "* >>> *", "* /deep/ *", "& *", "&", "& ~ *", "* & *", ":scope ~ *", ":not(:scope) ~ *", "#s{} *", "x{} ~ * *",
    "x{fill:red} *", "x{};*", "x{}}*", "}*", "}} ~ * *", "{} *", "@x; *", "@x{} ~ *", "@x y{} *", ")*", "]*", "x)~*", "(x)~ *",
    "\"x\" *", "'x' ~ *", "&lt;!-- *", "--> ~ *", "&lt;!-- ~ * *", "--> *", "*,", ",*", "*:x", "*|", "x *", "*/**/", "* /* ",
    "x/*{*/~ *", "\xc2\xa0*", "\xc2\xa0~ *", "*\xc2\xa0", "\xef\xbb\xbf*", "\\0 *", "\\", "*\\", "\\\n*", "#s\\ ~ *", "&#0x7e;"};
// clang-format on

/// Sheets that may hide a rule; `%` is its place.
inline constexpr std::array kLeavingSheets = {
    "%",
    "@media all{%}",
    "@media all{@media all{%}}",
    "@media screen{} %",
    "@supports (fill:red){%}",
    "@supports not (x:y){%}",
    "@layer x{%}",
    "@layer x; %",
    "@scope{%}",
    "@scope (#s) to (x){%}",
    "@container (width>0){%}",
    "@starting-style{%}",
    "@namespace url(http://www.w3.org/2000/svg); %",
    "@namespace s url(http://www.w3.org/2000/svg); %",
    "@charset \"utf-8\"; %",
    "@import url(x.css); %",
    "@font-face{} %",
    "@property --x{} %",
    "@page{%}",
    "@x;%",
    "@x{}%",
    "@x{%}",
    "x{%}",
    "svg{%}",
    "*{%}",
    "x{fill:red;%}",
    "x{fill:red} % x{fill:blue}",
    "x{fill:'} %",
    "x{fill:'\n} %",
    "x{fill:url(} %",
    "x{fill:url(') %",
    "x{fill:(} %",
    "x{fill:)} %",
    "x[y{} %",
    "x('){} %",
    "/* */%/* */",
    "/*/%/**/",
    "&lt;!-- % -->",
    "--> %",
    "<![CDATA[%]]>",
    "</style><style>%",
    "</style><style type='text/css' media='all'>%",
    "</style><defs><style>%</style></defs><style>",
    "</style><svg><style>%</style></svg><style>",
    "</style><metadata><style>%</style></metadata><style>",
    "</style><foreignObject><style xmlns='http://www.w3.org/1999/xhtml'>%</style></foreignObject><style>",
    "</style><text>&lt;/text>&lt;style>%&lt;/style></text><style>",
    "x{font-family:'&lt;/style>&lt;style>%'}",
    "x{fill:red}&#125;%"};

}  // namespace tessera::test
