// What is said, for tests of messages.
#pragma once

#include <string>

namespace crevice {

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// The message of the error of type E that `call` throws, or "" when it throws none.
template <class E, class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const E& error) {
        return error.what();
    }
    return "";
}

}  // namespace crevice
