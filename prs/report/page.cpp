#include "prs/report/page.h"

#include <fmt/format.h>
#include <nettle/base64.h>

#include <cstdint>

#include "prs/report/svg.h"
#include "prs/sha256.h"

namespace prs {
namespace {

constexpr std::string_view kStyle = R"(
:root{--ink:#1a1f24;--quiet:#5a646d;--line:#e3e6e8;--paper:#fff;--band:#f6f7f8;--link:#00619a;
--warn:#a33b00;--good:#00704f;color-scheme:light}
@media screen and (prefers-color-scheme:dark){:root{--ink:#e6e8ea;--quiet:#a3acb4;--line:#33393f;
--paper:#14181b;--band:#1c2125;--link:#7cc4f4;--warn:#ff9d66;--good:#4fd3a8;color-scheme:dark}}
*{box-sizing:border-box}
html{scroll-behavior:smooth;-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);
font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
a{color:var(--link);text-underline-offset:.15em}
.page{max-width:76rem;margin:0 auto;padding:2.5rem 1.25rem 4rem}
header{max-width:58rem}
.eyebrow{margin:0;color:var(--quiet);font-size:.8rem;letter-spacing:.08em;text-transform:uppercase}
h1{margin:.2rem 0 .4rem;font-size:2rem;line-height:1.2;font-weight:650;overflow-wrap:anywhere}
.lead{margin:0;color:var(--quiet);max-width:48rem}
h2{margin:0 0 1rem;padding-top:1.4rem;border-top:1px solid var(--line);font-size:1.3rem;
line-height:1.3;font-weight:650}
h3{margin:2rem 0 .6rem;font-size:1rem;font-weight:650}
section{margin-top:2.6rem;scroll-margin-top:1rem}
p{max-width:46rem}
nav{font-size:.88rem;margin:1.6rem 0}
nav ol{list-style:none;margin:0;padding:0;display:flex;flex-wrap:wrap;gap:.2rem 1.1rem}
nav a{color:var(--quiet);text-decoration:none}
nav a:hover,nav a:focus{color:var(--ink);text-decoration:underline}
.tiles{display:grid;grid-template-columns:repeat(auto-fill,minmax(14.5rem,1fr));gap:1px;margin:1.4rem 0;
padding:1px}
.tiles>div{box-shadow:0 0 0 1px var(--line);padding:.8rem 1rem}
.tiles dt{color:var(--quiet);font-size:.82rem}
.tiles dd{margin:.1rem 0 0}
.tiles .value{font-size:1.3rem;overflow-wrap:anywhere;font-weight:600;font-variant-numeric:tabular-nums;line-height:1.3}
.tiles .value small{font-size:.85rem;font-weight:400;color:var(--quiet)}
.tiles .where{font-size:.8rem;color:var(--quiet);overflow-wrap:anywhere}
.state{font-weight:600}.state.good{color:var(--good)}.state.bad{color:var(--warn)}
ul.warnings{padding-left:1.1rem;max-width:52rem}ul.warnings li{margin:.35rem 0;overflow-wrap:anywhere}
ul.warnings li::marker{color:var(--warn);content:"▲  ";font-size:.7em}
ul.warnings small{color:var(--quiet)}
figure{margin:1.4rem 0 2rem}
figcaption{font-weight:600;font-size:.95rem;margin-bottom:.3rem;overflow-wrap:anywhere}
.wide{overflow-x:auto}.wide:focus-visible,a:focus-visible{outline:2px solid var(--link);
outline-offset:2px}
figure .wide svg,figure .wide img{min-width:36rem}
figure.narrow{max-width:42rem}
img{display:block;width:100%;height:auto;background:#fff}
table{border-collapse:collapse;font-size:.87rem;font-variant-numeric:tabular-nums;min-width:min(100%,30rem);
margin:.4rem 0 1rem}
th,td{padding:.26rem .7rem .26rem 0;border-bottom:1px solid var(--line);text-align:left;
vertical-align:baseline;font-weight:400}
td,thead th{padding-left:.7rem}thead th:first-child{padding-left:0}
.quantities td,.quantities thead th{text-align:right;white-space:nowrap}
.quantities thead th:first-child{text-align:left}
.quantities td.unit,.quantities thead th.unit{text-align:left;color:var(--quiet)}
thead th{color:var(--quiet);font-size:.82rem;vertical-align:bottom;max-width:12rem}
.quantities thead th{white-space:normal;overflow-wrap:anywhere}
tbody tr:hover{background:var(--band)}
.group th{padding-top:1rem;font-weight:600}
tbody th[scope=row]{min-width:11rem}
.default{color:var(--quiet)}
code,.mono{font-family:ui-monospace,SFMono-Regular,Menlo,Consolas,monospace;font-size:.86em;
overflow-wrap:anywhere}
dl.facts{display:grid;grid-template-columns:max-content 1fr;gap:.3rem 1.4rem;font-size:.9rem}
dl.facts dt{color:var(--quiet)}dl.facts dd{margin:0;overflow-wrap:anywhere;min-width:0}
ul.files{list-style:none;padding:0;columns:16rem;font-size:.9rem}
footer{margin-top:3rem;padding-top:1rem;border-top:1px solid var(--line);color:var(--quiet);
font-size:.82rem}
@media screen and (min-width:64rem){.page{display:grid;grid-template-columns:minmax(0,1fr) 13rem;
column-gap:3.5rem}
header,main,footer{grid-column:1}
nav{grid-column:2;grid-row:1/span 3;position:sticky;top:2.5rem;align-self:start;margin:.4rem 0 0}
nav ol{display:block;border-left:1px solid var(--line);padding-left:1.1rem}nav li{margin:.32rem 0}}
@media (max-width:34rem){.tiles{grid-template-columns:repeat(auto-fill,minmax(9rem,1fr))}.tiles>div{padding:.6rem .7rem}
.tiles .value{font-size:1.1rem;white-space:normal}.page{padding-top:1.4rem}h1{font-size:1.5rem}
dl.facts{grid-template-columns:1fr;gap:0}dl.facts dd{margin-bottom:.5rem}}
@media print{@page{size:A4;margin:16mm 15mm 18mm}
body{font-size:9.5pt;line-height:1.4}
.page{padding:0;max-width:none}nav{display:none}
section{margin-top:1.4rem}h1{font-size:20pt}h2{font-size:13pt;break-after:avoid}h3{break-after:avoid}
figure,.tiles>div,tr{break-inside:avoid}figcaption{break-after:avoid}
.tiles{grid-template-columns:repeat(4,1fr)}.tiles .value{font-size:12pt}
.wide{overflow:visible}figure .wide svg,figure .wide img{min-width:0}
figure.narrow{max-width:95mm}
table{font-size:8pt;min-width:0}tbody th[scope=row]{min-width:0}thead{display:table-header-group}
.quantities td{white-space:normal}td.unit,th.unit{white-space:nowrap!important}th,td{padding:.15rem .35rem .15rem 0}
figure svg{max-height:112mm}a{color:inherit;text-decoration:none}
svg rect,svg path,.tiles{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)";

std::string base64(std::string_view bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return text;
}

/// As policies name a style or a script by its text.
std::string policy_hash(std::string_view text) {
  const std::string digest = sha256(text);
  std::string bytes;
  for (std::size_t k = 0; k < digest.size(); k += 2)
    bytes += static_cast<char>(std::stoi(digest.substr(k, 2), nullptr, 16));
  return "sha256-" + base64(bytes);
}

/// A text as a URL has it; the page escapes quotes and markup besides.
std::string data_url(std::string_view type, std::string_view content) {
  std::string url = fmt::format("data:{};charset=utf-8,", type);
  for (const char c : content) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte >= 0x7f ||
        std::string_view("%#\"'<>&\\^`{|}").find(c) != std::string_view::npos)
      url += fmt::format("%{:02X}", byte);
    else
      url += c;
  }
  return url;
}

/// In a script element no `<` may stand.
std::string script_data(const std::string& json) {
  std::string text;
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

}  // namespace

std::string download_link(std::string_view name, std::string_view type, std::string_view content) {
  return fmt::format("<a download=\"{0}\" href=\"{1}\">{0}</a>", html(name),
                     data_url(type, content));
}

std::string embedded_svg(std::string_view svg, std::string_view title) {
  return fmt::format("<img alt=\"{}\" src=\"{}\">", html(title), data_url("image/svg+xml", svg));
}

std::string page_html(const Page& page) {
  const std::string style = std::string(kStyle) + svg_style();
  std::string links, body;
  for (const PageSection& section : page.sections) {
    if (section.body.empty()) continue;
    links += fmt::format("<li><a href=\"#{}\">{}</a></li>", section.id, section.title);
    body += fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 "
        "id=\"{0}-title\">{1}</h2>\n{2}</section>\n",
        section.id, section.title, section.body);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src '{}'; "
      "img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"referrer\" content=\"no-referrer\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<div class=\"page\">\n"
      "<header>\n{}</header>\n<nav aria-label=\"Contents\"><ol>{}</ol></nav>\n<main>\n{}</main>\n"
      "<footer>{}</footer>\n</div>\n<script type=\"application/json\" id=\"data\">{}</script>\n"
      "</body>\n</html>\n",
      policy_hash(style), html(page.title), style, page.head, links, body, page.foot,
      script_data(page.data));
}

}  // namespace prs
