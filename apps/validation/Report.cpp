#include "Report.h"

#include "Svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swellray::validation
{

namespace
{

constexpr const char* Style =
  "body{font:15px/1.45 sans-serif;color:#222;background:#fff;max-width:1460px;margin:2em auto;padding:0 1em}"
  "table{border-collapse:collapse;margin:.6em 0}td,th{padding:.2em .8em .2em 0;text-align:left;border-bottom:1px solid "
  "#e4e4e4;vertical-align:top}td.n{font-family:monospace;text-align:right}.pass{color:#00704a}.FAIL{color:#b00020;"
  "font-weight:bold}.shown{color:#777}h2{margin-top:2em}svg{max-width:100%;height:auto}code{background:#f4f4f4;padding:"
  "0 "
  ".3em}";

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return result + '"';
}

std::string checksCsv(const std::vector<Finding>& findings)
{
  std::string text = "case,quantity,value,limit,asked,verdict,reason\n";
  for (const Finding& finding : findings)
  {
    for (const Check& check : finding.outcome.checks)
    {
      const char* asked = check.ask == Check::Ask::AtMost ? "at most"
        : check.ask == Check::Ask::AtLeast                ? "at least"
                                                          : "nothing";
      text += fmt::format("{},{},{:.6g},{:.6g},{},{},{}\n", finding.what.name, quoted(check.quantity), check.value,
        check.limit, asked, verdictOf(check), quoted(check.reason));
    }
  }
  return text;
}

std::string numbersCsv(const Table& table)
{
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const std::vector<double>& row : table.rows)
  {
    text += fmt::format("{:.17g}\n", fmt::join(row, ","));
  }
  return text;
}

std::string summaryRow(const Finding& finding)
{
  std::size_t failed = 0;
  for (const Check& check : finding.outcome.checks)
  {
    failed += !check.passed();
  }
  const std::string verdict = finding.outcome.passed() ? "pass" : "FAIL";
  return fmt::format("<tr><td><a href='#{0}'>{0}</a></td><td>{1}</td><td class='n'>{2}</td><td class='n'>{3}</td>"
                     "<td class='{4}'>{4}</td></tr>\n",
    finding.what.name, escapeXml(finding.what.title), finding.outcome.checks.size(), failed, verdict);
}

std::string caseSection(const Finding& finding, const std::string& picture)
{
  std::string text = fmt::format("<h2 id='{0}'>{1}</h2>\n<p><code>{0}</code> {2}</p>\n", finding.what.name,
    escapeXml(finding.what.title), escapeXml(finding.what.about));
  text += picture;
  text += "<table><tr><th>quantity</th><th>found</th><th>tolerance</th><th>verdict</th><th>where the tolerance comes "
          "from</th></tr>\n";
  for (const Check& check : finding.outcome.checks)
  {
    const std::string verdict = verdictOf(check);
    text +=
      fmt::format("<tr><td>{}</td><td class='n'>{}</td><td class='n'>{}</td><td class='{}'>{}</td><td>{}</td></tr>\n",
        escapeXml(check.quantity), formatValue(check.value), escapeXml(formatLimit(check)), verdict, verdict,
        escapeXml(check.reason));
  }
  return text +
    fmt::format("</table>\n<p><a href='{0}.csv'>numbers</a>, <a href='{0}.svg'>picture</a>, {1:.2f} s</p>\n",
      finding.what.name, finding.seconds);
}

}

std::string formatValue(double value)
{
  if (!std::isfinite(value))
  {
    return std::isnan(value) ? "none" : "infinite";
  }
  const bool plain = value == 0.0 || (std::abs(value) >= 0.01 && std::abs(value) < 1e4);
  return plain ? fmt::format("{:.4g}", value) : fmt::format("{:.1e}", value);
}

std::string formatLimit(const Check& check)
{
  switch (check.ask)
  {
  case Check::Ask::AtMost:
    return "<= " + formatValue(check.limit);
  case Check::Ask::AtLeast:
    return ">= " + formatValue(check.limit);
  case Check::Ask::Nothing:
    break;
  }
  return "-";
}

std::string verdictOf(const Check& check)
{
  return check.ask == Check::Ask::Nothing ? "shown" : check.passed() ? "pass" : "FAIL";
}

std::vector<ReportFile> makeReport(const std::vector<Finding>& findings, const ReportHead& head)
{
  std::vector<ReportFile> files;
  std::string rows;
  std::string sections;
  for (const Finding& finding : findings)
  {
    const std::string picture = drawSvg(finding.outcome.plots);
    rows += summaryRow(finding);
    sections += caseSection(finding, picture);
    files.push_back({ finding.what.name + ".svg", picture });
    files.push_back({ finding.what.name + ".csv", numbersCsv(finding.outcome.numbers) });
    if (!finding.outcome.grids.rows.empty())
    {
      files.push_back({ finding.what.name + "_grids.csv", numbersCsv(finding.outcome.grids) });
    }
  }
  files.push_back({ "checks.csv", checksCsv(findings) });
  const auto failed =
    std::count_if(findings.begin(), findings.end(), [](const Finding& finding) { return !finding.outcome.passed(); });
  const std::string verdict = failed == 0
    ? fmt::format("<p class='pass'>All {} cases pass.</p>", findings.size())
    : fmt::format("<p class='FAIL'>{} of {} cases fail.</p>", failed, findings.size());
  files.push_back({ "index.html",
    fmt::format(
      "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><title>Swellray validation</title>\n"
      "<style>{}</style></head><body>\n<h1>Swellray validation</h1>\n<p>{} &middot; <code>{}</code></p>\n{}\n{}\n"
      "<p>Every exact side is computed from its formula by code that shares no ray equation with the tracer: closed "
      "forms "
      "and quadratures in long double, and the ray-tube equations of Munk and Arthur 1952. Values that stand beside a "
      "tolerance of the integrator other than its finest say so (default: 1e-8 a step).</p>\n"
      "<table><tr><th>case</th><th></th><th>checks</th><th>failed</th><th>verdict</th></tr>\n{}</table>\n{}</body></"
      "html>\n",
      Style, escapeXml(head.version), escapeXml(head.commandLine), verdict,
      head.perturbed ? "<p class='FAIL'>Run with a formula made wrong on purpose, to check the checker.</p>" : "", rows,
      sections) });
  return files;
}

}
