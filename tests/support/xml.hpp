#pragma once

#include <expat.h>

#include <map>
#include <string>
#include <vector>

/// XML as a list of its elements, read by expat: whatever is not well-formed is an error.
namespace visibility::test {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< directly inside
  std::size_t depth;
};

struct XmlDocument {
  std::vector<XmlElement> elements;  ///< in the order of their start tags
  std::string fault;                 ///< empty: well-formed
};

inline XmlDocument parse_xml(std::string const& text)
{
  struct State {
    XmlDocument document;
    std::vector<std::size_t> open;
  } state;
  XML_Parser const parser = XML_ParserCreate(nullptr);
  XML_SetUserData(parser, &state);
  XML_SetElementHandler(
    parser,
    [](void* data, XML_Char const* name, XML_Char const** attributes) {
      auto& s = *static_cast<State*>(data);
      XmlElement e{name, {}, {}, s.open.size()};
      for (; *attributes != nullptr; attributes += 2) e.attributes[attributes[0]] = attributes[1];
      s.open.push_back(s.document.elements.size());
      s.document.elements.push_back(std::move(e));
    },
    [](void* data, XML_Char const*) { static_cast<State*>(data)->open.pop_back(); });
  XML_SetCharacterDataHandler(parser, [](void* data, XML_Char const* part, int length) {
    auto& s = *static_cast<State*>(data);
    s.document.elements[s.open.back()].text.append(part, static_cast<std::size_t>(length));
  });
  if (XML_Parse(parser, text.data(), static_cast<int>(text.size()), 1) == XML_STATUS_ERROR)
    state.document.fault = std::string(XML_ErrorString(XML_GetErrorCode(parser))) + " in line " +
                           std::to_string(XML_GetCurrentLineNumber(parser));
  XML_ParserFree(parser);
  return std::move(state.document);
}

/// Of the group with this id: its elements of a kind, at any depth.
inline std::vector<XmlElement> elements_in(XmlDocument const& document, std::string const& id, std::string const& name)
{
  std::vector<XmlElement> out;
  for (std::size_t i = 0; i < document.elements.size(); ++i) {
    auto const& group = document.elements[i];
    if (!group.attributes.contains("id") || group.attributes.at("id") != id) continue;
    for (++i; i < document.elements.size() && document.elements[i].depth > group.depth; ++i)
      if (document.elements[i].name == name) out.push_back(document.elements[i]);
    break;
  }
  return out;
}

}  // namespace visibility::test
