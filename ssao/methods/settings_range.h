// What settings are refused with: UsageError "MEMBER: must lie in RANGE (value); choose another value".
#pragma once

namespace crevice {

// A length in [0, inf), scene units.
void require_length(const char* member, double value);
void require_within(const char* member, double value, double lowest, double highest);

}  // namespace crevice
