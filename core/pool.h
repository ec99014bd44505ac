// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that are dear to make and serve one thread at a time, such as evaluators with variables of their own: as many
// of them as threads have ever asked at the same time.
// Guarantee: safe for many threads; no object is used by two at once. Cost: one lock to lend and one to take back.
//
//     core::Pool<Evaluator> evaluators([text] { return std::make_unique<Evaluator>(text); });
//     double y = evaluators.use([x](Evaluator& evaluator) { return evaluator.value(x); });
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace dsc::core {

template <class Object>
class Pool {
public:
    using Make = std::function<std::unique_ptr<Object>()>;

    /// `make` is called whenever no object is idle, by several threads at a time.
    explicit Pool(Make make) : make_(std::move(make)) {}

    /// What `call` returns of an object that is its own while it runs.
    template <class Call>
    decltype(auto) use(Call&& call) {
        Loan loan(*this);
        return std::forward<Call>(call)(*loan.object);
    }

private:
    struct Loan {
        explicit Loan(Pool& lender) : pool(lender), object(pool.taken()) {}
        ~Loan() {
            const std::lock_guard lock(pool.mutex_);
            pool.idle_.push_back(std::move(object));
        }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        Pool& pool;
        std::unique_ptr<Object> object;
    };

    std::unique_ptr<Object> taken() {
        {
            const std::lock_guard lock(mutex_);
            if (!idle_.empty()) {
                std::unique_ptr<Object> object = std::move(idle_.back());
                idle_.pop_back();
                return object;
            }
        }
        return make_();
    }

    Make make_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Object>> idle_;
};

}  // namespace dsc::core
