#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "core/study/provenance/sha256.h"

namespace noonmark {

struct Sha256::Digest {
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
    bool sound = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
};

Sha256::Sha256() : digest_(std::make_unique<Digest>()) {}
Sha256::~Sha256() = default;

void Sha256::add(const void* bytes, std::size_t count) {
    digest_->sound = digest_->sound && EVP_DigestUpdate(digest_->context.get(), bytes, count) == 1;
}

std::string Sha256::hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
    unsigned length = 0;
    if (!digest_->sound || EVP_DigestFinal_ex(digest_->context.get(), sum.data(), &length) != 1) return {};
    std::string text;
    for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", sum[i]);
    return text;
}

}  // namespace noonmark
