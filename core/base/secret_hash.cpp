#include "base/secret_hash.h"

#include <openssl/evp.h>
#include <openssl/rand.h>
#include <array>

#include "base/result.h"

namespace glisson {
namespace {

template <std::size_t count>
std::string hexadecimal(const std::array<unsigned char, count>& bytes) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : bytes) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

}  // namespace

std::string new_salt() {
  std::array<unsigned char, 16> bytes{};
  GLISSON_ASSERT(RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) == 1);
  return hexadecimal(bytes);
}

std::string secret_hash(std::string_view secret, std::string_view salt) {
  constexpr int rounds = 100000;
  std::array<unsigned char, 32> bytes{};
  const int made = PKCS5_PBKDF2_HMAC(secret.data(), static_cast<int>(secret.size()),
                                     reinterpret_cast<const unsigned char*>(salt.data()), static_cast<int>(salt.size()),
                                     rounds, EVP_sha256(), static_cast<int>(bytes.size()), bytes.data());
  GLISSON_ASSERT(made == 1);
  return hexadecimal(bytes);
}

}  // namespace glisson
