#include "host/cli/check/page.hpp"

#include <fmt/format.h>

#include "host/cli/check/report.hpp"
#include "host/io/base64.hpp"

namespace quell::cli {
namespace {

constexpr char kStyle[] =
    "body{font:16px/1.45 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}"
    "td{padding:.1rem 1rem .1rem 0}td+td{text-align:right}section{border-left:.4rem "
    "solid;padding-left:1rem;margin:1.5rem 0}"
    ".note{border-color:#999}.doubtful{border-color:#d90}.wrong{border-color:#c22}img{max-width:100%;image-"
    "rendering:pixelated}"
    "h2 small{font-weight:normal}";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '&')
      result += "&amp;";
    else
      result += c;
  }
  return result;
}

std::string figureRow(const SequenceFigure& figure) {
  return fmt::format("<tr><td>{}</td><td>{:.2f} {}</td><td>{:.2f} to {:.2f}</td></tr>\n",
                     escaped(figure.figure.name), figure.figure.value, figure.figure.unit, figure.least,
                     figure.most);
}

std::string findingSection(const SequenceFinding& found, const std::map<std::string, std::string>& pngs) {
  const Finding& finding = found.finding;
  std::string text = fmt::format("<section class=\"{0}\"><h2>{1} <small>{0}, {2}</small></h2>\n",
                                 toString(finding.severity), escaped(finding.kind), framesText(found.frames));
  text += fmt::format("<p>{}</p><p>Expected {}, got {}.</p><p><b>{}</b></p>\n", escaped(found.file),
                      escaped(finding.expected), escaped(gotText(finding)), escaped(finding.cure));
  if (const auto png = pngs.find(finding.kind); png != pngs.end())
    text += fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n", escaped(finding.kind),
                        io::base64(png->second));
  return text + "</section>\n";
}

}  // namespace

std::string checkPage(const std::string& name, const SequenceCheck& check,
                      const std::map<std::string, std::string>& pngs) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>{0}: {1}</title><style>{2}</style>\n"
      "<h1>{1}</h1><p>{0}, {3}</p>\n<table>\n",
      escaped(name), verdictOf(check.worst()), kStyle, framesText(check.frames));
  for (const SequenceFigure& figure : check.figures) page += figureRow(figure);
  page += "</table>\n";
  for (const SequenceFinding& found : check.findings) page += findingSection(found, pngs);
  return page;
}

}  // namespace quell::cli
