// Whether a picture is XML that every reader accepts: elements that close in the order in which they opened, and no
// attribute twice.
#pragma once

#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace crevice {

// What is wrong, with the place; empty where nothing is.
inline std::string xml_fault(const std::string& xml) {
    std::vector<std::string> open;
    for (std::size_t at = xml.find('<'); at != xml.npos; at = xml.find('<', at + 1)) {
        std::size_t i = at + 1;
        const bool closes = xml[i] == '/';
        if (closes) ++i;
        const auto name_from = [&xml](std::size_t& place) {
            const std::size_t begin = place;
            while (std::isalnum(static_cast<unsigned char>(xml[place])) || xml[place] == '-' ||
                   xml[place] == ':')
                ++place;
            return xml.substr(begin, place - begin);
        };
        const std::string element = name_from(i);
        if (closes) {
            if (open.empty() || open.back() != element)
                return "</" + element + "> closes nothing: " + xml.substr(at, 60);
            open.pop_back();
            continue;
        }
        std::set<std::string> attributes;
        while (i < xml.size() && xml[i] != '>' && xml[i] != '/') {
            if (xml[i] == ' ' || xml[i] == '\n') {
                ++i;
                continue;
            }
            const std::string attribute = name_from(i);
            if (attribute.empty() || xml.compare(i, 2, "=\"") != 0)
                return "not an attribute: " + xml.substr(at, 60);
            if (!attributes.insert(attribute).second)
                return attribute + " is there twice: " + xml.substr(at, 90);
            i = xml.find('"', i + 2);
            if (i == xml.npos) return "a value without an end: " + xml.substr(at, 60);
            ++i;
        }
        if (xml.compare(i, 2, "/>") != 0) open.push_back(element);
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

}  // namespace crevice
