#include "mjcf_defaults.h"

#include <algorithm>

namespace lacuna::mjcf {
namespace {

constexpr const char* kMain = "main";

}  // namespace

bool Attributes::flag(const char* attribute, bool otherwise) const {
  const std::optional<std::string> text = text_of(attribute);
  if (!text || *text == "auto") return otherwise;
  if (*text == "true" || *text == "false") return *text == "true";
  source_of(attribute).problem(std::string(attribute) + " \"" + *text + "\" must be true, false or auto");
  return otherwise;
}

const XmlElement& Attributes::source_of(const char* attribute) const {
  if (element_.text_of(attribute)) return element_;
  const auto found = std::find_if(defaults_.begin(), defaults_.end(),
                                  [&](const XmlElement& one) { return one.text_of(attribute).has_value(); });
  return found == defaults_.end() ? element_ : *found;
}

DefaultClasses::DefaultClasses(const Document& document) {
  classes_.try_emplace(kMain);
  for (const XmlElement& section : document.sections())
    if (section.name() == "default") read(document, section, "");
}

void DefaultClasses::read(const Document& document, const XmlElement& element, const std::string& around) {
  std::string name = element.text_of("class").value_or("");
  if (name.empty() && !around.empty()) return element.problem("a default inside another needs a class");
  if (name.empty()) name = kMain;
  const auto [known, is_new] = classes_.try_emplace(name);
  if (is_new) known->second.around = around.empty() ? kMain : around;
  for (const XmlElement& child : document.children(element))
    if (child.name() == "default")
      read(document, child, name);
    else
      known->second.elements.push_back(child);
}

Attributes DefaultClasses::of(const XmlElement& element, const std::string& childclass,
                              const std::vector<std::string_view>& also) const {
  const std::optional<std::string> own = element.text_of("class");
  std::string name = own.value_or(childclass.empty() ? kMain : childclass);
  if (own && !has(*own)) element.problem("there is no default class \"" + *own + "\"");
  std::vector<XmlElement> defaults;
  for (auto found = classes_.find(name); found != classes_.end(); found = classes_.find(found->second.around))
    for (auto one = found->second.elements.rbegin(); one != found->second.elements.rend(); ++one)
      if (one->name() == element.name() || std::find(also.begin(), also.end(), one->name()) != also.end())
        defaults.push_back(*one);
  return {element, std::move(defaults)};
}

}  // namespace lacuna::mjcf
