// A pair of shaders, and the numbers they are given by name.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace crevice {

class GlProgram {
 public:
    // `prefix` stands before both texts. Throws InputError with the compiler's words.
    GlProgram(const std::string& prefix, const std::string& vertices, const std::string& pixels);
    ~GlProgram();
    GlProgram(const GlProgram&) = delete;
    GlProgram& operator=(const GlProgram&) = delete;

    void use() const;
    // The program need not be in use. Names that the compiler found unused are passed over.
    void set(const char* name, float value) const;
    void set(const char* name, glm::vec2 value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat4& value) const;
    void set(const char* name, std::span<const float> values) const;
    void set(const char* name, std::span<const glm::vec3> values) const;

 private:
    int place(const char* name) const;

    std::uint32_t program_ = 0;
};

}  // namespace crevice
