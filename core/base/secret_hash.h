#pragma once
// Whether two names are the same, without keeping either: salted hashes that are slow to try names against.

#include <string>
#include <string_view>

namespace glisson {

// 32 hexadecimal digits from the system's source of randomness.
[[nodiscard]] std::string new_salt();

// PBKDF2 with HMAC-SHA-256 and 100,000 rounds (RFC 8018), as 64 hexadecimal digits; tens of milliseconds. Of a secret
// that is one of few (a number of six digits) it hides no more than that few must be tried.
[[nodiscard]] std::string secret_hash(std::string_view secret, std::string_view salt);

}  // namespace glisson
