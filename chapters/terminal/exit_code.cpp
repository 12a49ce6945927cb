#include "chapters/terminal/exit_code.h"

#include <iostream>
#include <new>

#include "rasterizer/base/error.h"

namespace crevice {

int exit_code_of(const std::function<int()>& body) {
    try {
        return body();
    } catch (const Error& error) {
        std::cerr << error.what() << "\n";
        return static_cast<int>(error.code);
    } catch (const std::bad_alloc&) {
        std::cerr << "crevice: not enough memory for this; choose a smaller --size\n";
        return static_cast<int>(ExitCode::usage);
    } catch (const std::exception& error) {
        std::cerr << "crevice: this should not have happened (" << error.what() << "); please report it\n";
        return static_cast<int>(ExitCode::check_failed);
    }
}

}  // namespace crevice
