#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <string>
#include <thread>

namespace noonmark::tests {

/// Listens on a free port of this computer and counts connections; sends no answers.
class LocalListener {
public:
    LocalListener() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto* any = reinterpret_cast<sockaddr*>(&address);
        listening_ = ::bind(socket_, any, size) == 0 && ::listen(socket_, 16) == 0 &&
                     ::getsockname(socket_, any, &size) == 0;
        port_ = ntohs(address.sin_port);
        thread_ = std::jthread([this](const std::stop_token& stop) { acceptAll(stop); });
    }
    LocalListener(const LocalListener&) = delete;
    LocalListener& operator=(const LocalListener&) = delete;
    ~LocalListener() {
        thread_.request_stop();
        thread_.join();
        ::close(socket_);
    }

    [[nodiscard]] bool listening() const { return listening_; }
    [[nodiscard]] std::string port() const { return std::to_string(port_); }
    [[nodiscard]] std::string address() const { return "http://127.0.0.1:" + port(); }
    [[nodiscard]] int connections() const { return connections_; }

private:
    void acceptAll(const std::stop_token& stop) {
        constexpr int waitMs = 20;
        while (!stop.stop_requested()) {
            pollfd ready{socket_, POLLIN, 0};
            if (::poll(&ready, 1, waitMs) != 1) continue;
            const int caller = ::accept(socket_, nullptr, nullptr);
            if (caller < 0) continue;
            ++connections_;
            ::close(caller);
        }
    }

    int socket_;
    int port_ = 0;
    bool listening_ = false;
    std::atomic<int> connections_ = 0;
    std::jthread thread_;
};

}  // namespace noonmark::tests
