// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/HtmlReport.h"

#include "core/base/Contracts.h"

#include <fmt/format.h>
#include <md4c-html.h>

namespace toile::batch {
namespace {

/// Follows the browser's light or dark colours; wide tables scroll on their own, pictures keep their white ground.
constexpr const char* style = R"(
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem; }
table { display: block; overflow-x: auto; border-collapse: collapse; margin: 1rem 0; font-size: 0.875rem; }
th, td { padding: 0.25rem 0.6rem; border-bottom: 1px solid #8885; text-align: left; font-variant-numeric: tabular-nums; }
th { vertical-align: bottom; border-bottom: 2px solid #888; }
tbody tr:hover { background: #8882; }
img { max-width: 100%; background: white; }
code { font-size: 0.9em; background: #8882; padding: 0.1em 0.3em; border-radius: 3px; }
)";

std::string escaped(const std::string& text) {
    std::string html;
    for (const char c : text)
        if (c == '&') html += "&amp;";
        else if (c == '<') html += "&lt;";
        else html += c;
    return html;
}

std::string titleOf(const std::string& markdown) {
    const std::string first = markdown.substr(0, markdown.find('\n'));
    return escaped(first.starts_with("# ") ? first.substr(2) : first);
}

void append(const MD_CHAR* text, MD_SIZE size, void* to) {
    static_cast<std::string*>(to)->append(text, size);
}

} // namespace

std::string htmlReport(const std::string& markdown) {
    std::string body;
    const int failed = md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &body,
                               MD_DIALECT_GITHUB | MD_FLAG_NOHTML, MD_HTML_FLAG_SKIP_UTF8_BOM);
    expects(failed == 0, "Markdown becomes a page");
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                       "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
                       titleOf(markdown), style, body);
}

} // namespace toile::batch
