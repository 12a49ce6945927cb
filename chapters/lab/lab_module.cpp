// The lab as a WebAssembly module: the few functions that its worker calls. Text crosses as UTF-8 that ends with a zero.
#include <string>

#include "chapters/lab/lab.h"

extern "C" {

// The reply to a request, see lab.h. It stays in its place until the next call.
const char* lab_reply(const char* request) {
    static crevice::Lab lab;
    static std::string reply;
    reply = lab.reply(request);
    return reply.c_str();
}

}  // extern "C"
