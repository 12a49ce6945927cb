#include "tests/peers/gl_program.h"

#include <glm/gtc/type_ptr.hpp>

#include "rasterizer/base/error.h"
#include "tests/peers/gl_functions.h"

namespace crevice {

namespace {

constexpr int kLongestLog = 4096;

GLuint compiled(GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint good = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    std::string log(kLongestLog, '\0');
    glGetShaderInfoLog(shader, kLongestLog, nullptr, log.data());
    throw InputError("shader: does not compile (" + log + "); use the Mesa of Debian 12 or newer");
}

}  // namespace

GlProgram::GlProgram(const std::string& prefix, const std::string& vertices, const std::string& pixels)
    : program_(glCreateProgram()) {
    for (const GLuint shader :
         {compiled(GL_VERTEX_SHADER, prefix + vertices), compiled(GL_FRAGMENT_SHADER, prefix + pixels)}) {
        glAttachShader(program_, shader);
        glDeleteShader(shader);  // when the program goes
    }
    glLinkProgram(program_);
    GLint good = GL_FALSE;
    glGetProgramiv(program_, GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return;
    std::string log(kLongestLog, '\0');
    glGetProgramInfoLog(program_, kLongestLog, nullptr, log.data());
    throw InputError("shaders: do not link (" + log + "); use the Mesa of Debian 12 or newer");
}

GlProgram::~GlProgram() { glDeleteProgram(program_); }

void GlProgram::use() const { glUseProgram(program_); }

int GlProgram::place(const char* name) const { return glGetUniformLocation(program_, name); }

void GlProgram::set(const char* name, float value) const { glProgramUniform1f(program_, place(name), value); }
void GlProgram::set(const char* name, glm::vec2 value) const {
    glProgramUniform2f(program_, place(name), value.x, value.y);
}
void GlProgram::set(const char* name, const glm::vec3& value) const {
    glProgramUniform3f(program_, place(name), value.x, value.y, value.z);
}
void GlProgram::set(const char* name, const glm::vec4& value) const {
    glProgramUniform4fv(program_, place(name), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* name, const glm::mat4& value) const {
    glProgramUniformMatrix4fv(program_, place(name), 1, GL_FALSE, glm::value_ptr(value));
}
void GlProgram::set(const char* name, std::span<const float> values) const {
    glProgramUniform1fv(program_, place(name), static_cast<GLsizei>(values.size()), values.data());
}
void GlProgram::set(const char* name, std::span<const glm::vec3> values) const {
    glProgramUniform3fv(program_, place(name), static_cast<GLsizei>(values.size()),
                        glm::value_ptr(values.front()));
}

}  // namespace crevice
