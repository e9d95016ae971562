#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace noonmark {

/// SHA-256 of bytes that are added in pieces. Backend: sha256_openssl.cpp.
class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(const void* bytes, std::size_t count);
    void add(std::string_view text) { add(text.data(), text.size()); }

    /// Adds numbers and vectors of them in this machine's representation: the hash is the same only on
    /// machines with the same representation. Not for types with padding.
    template <class T>
    requires std::has_unique_object_representations_v<T> || std::is_floating_point_v<T>
    void add(const T& value) { add(&value, sizeof value); }

    /// Lower-case; empty if the library failed, for lack of memory. Call once, at the end.
    [[nodiscard]] std::string hex();

private:
    struct Digest;
    std::unique_ptr<Digest> digest_;
};

}  // namespace noonmark
