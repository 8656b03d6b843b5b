// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Three stages, each run on request only: true boxes (update), tree (update_tree), pairs (find_pairs).
// When memory runs out a stage reports it and leaves its work list as it was, so that a later call can
// succeed.
#include "collide/broadphase.h"

#include <algorithm>

namespace epode {
namespace {

bool keep(Array<SlotPair>& found, int a, int b)
{
    return found.push(a > b ? SlotPair{a, b} : SlotPair{b, a});
}

Aabb grow(const Aabb& box, Real margin)
{
    const Vec3 m{margin, margin, margin};
    return {box.lo - m, box.hi + m};
}

}  // namespace

bool Broadphase::reserve(int slots)
{
    const int old = proxies_.size();
    if (slots <= old) return true;
    // Work lists hold each slot at most once: with this capacity no append can fail.
    if (!escaped_.reserve(slots) || !fresh_.reserve(slots) || !unbounded_.reserve(slots) ||
        !notes_.resize(slots) || !proxies_.resize(slots))
        return false;
    for (int i = old; i < slots; ++i) proxies_[i] = Proxy{};
    return true;
}

void Broadphase::update(int slot, const Aabb& box, bool present)
{
    if (!present)
        remove(slot);
    else if (note(slot, box))
        (void)escaped_.push(slot);
}

bool Broadphase::note(int slot, const Aabb& box)
{
    Proxy& p = proxies_.data()[slot];
    const Vec3 a = abs(box.lo - p.box.lo), b = abs(box.hi - p.box.hi);
    p.shift = max_component(max(a, b));
    p.box = p.way = box;
    const bool kept = p.present && !p.escaped && p.leaf >= 0 && contains(tree_.box(p.leaf), box);
    p.present = true;
    if (kept || p.escaped) return false;
    return p.escaped = true;
}

bool Broadphase::note_way(int slot, const Aabb& way)
{
    Proxy& p = proxies_.data()[slot];
    p.way = bounded(way) ? way : p.box;
    if (p.escaped || p.leaf < 0 || contains(tree_.box(p.leaf), p.way)) return false;
    return p.escaped = true;
}

void Broadphase::withdraw(int slot)
{
    Proxy& p = proxies_[slot];
    leave_tree(p);
    leave_unbounded(slot);
    p.present = p.settled = false;
    stale_pairs_ = true;
}

void Broadphase::remove(int slot)
{
    if (proxies_[slot].present) withdraw(slot);
}

void Broadphase::clear()
{
    tree_changes();
    tree_.clear();
    for (Proxy& p : proxies_) p = Proxy{};
    for (Array<int>* list : {&unbounded_, &escaped_, &fresh_}) list->clear();
    pairs_.clear();
    stale_pairs_ = false;
}

void Broadphase::renumber(std::span<const int> new_slot, int count)
{
    drop_stale_pairs();
    tree_changes();  // its leaves hold slots
    for (SlotPair& pair : pairs_)
        pair = {new_slot[std::size_t(pair.newer)], new_slot[std::size_t(pair.older)]};
    for (Array<int>* list : {&unbounded_, &escaped_, &fresh_}) {
        int kept = 0;
        for (int slot : *list)
            if (new_slot[std::size_t(slot)] >= 0) (*list)[kept++] = new_slot[std::size_t(slot)];
        list->truncate(kept);
    }
    for (std::size_t i = 0; i < new_slot.size(); ++i) {
        const int to = new_slot[i];
        if (to < 0) continue;
        proxies_[to] = proxies_[int(i)];
        if (proxies_[to].leaf >= 0) tree_.set_item(proxies_[to].leaf, to);
    }
    for (int i = count; i < proxies_.size(); ++i) proxies_[i] = Proxy{};
}

const Aabb& Broadphase::fat_box(const Proxy& proxy) const
{
    return proxy.leaf >= 0 ? tree_.box(proxy.leaf) : proxy.box;
}

void Broadphase::tree_changes()
{
    ray_tree_.clear();
    rays_ = 0;
}

// The copy costs about as much as a ray for every few dozen leaves.
bool Broadphase::prepare(int rays)
{
    if (!update_tree()) return false;
    if (!ray_tree_.empty() || tree_.leaf_count() < 8) return true;
    rays_ = rays < tree_.leaf_count() ? rays_ + rays : tree_.leaf_count();
    if (rays_ > tree_.leaf_count() / 16) (void)ray_tree_.build(tree_);
    return true;
}

bool Broadphase::update_tree(const Tasks& tasks)
{
    if (ready()) return true;
    tree_changes();
    const bool in_bulk = escaped_.size() > 32 && escaped_.size() > tree_.leaf_count() / 6;
    int done = 0;
    bool placed = true;
    while (done < escaped_.size() && (placed = place(escaped_[done], in_bulk))) ++done;
    std::copy(escaped_.begin() + done, escaped_.end(), escaped_.begin());
    escaped_.truncate(escaped_.size() - done);
    return (tree_.sound() || tree_.settle(tasks)) && placed;
}

// A box that has never moved gets no margin: most of those never will.
Aabb Broadphase::fatten(const Proxy& p)
{
    const Real size = max_component(p.box.hi - p.box.lo);
    const Real shift = p.shift < size ? p.shift : size;  // also when it is not a number
    return p.settled ? grow(p.way, std::clamp(4 * shift, Real(0.02) * size, Real(0.1) * size)) : p.way;
}

void Broadphase::leave_unbounded(int slot)
{
    const int* at = std::find(unbounded_.begin(), unbounded_.end(), slot);
    if (at != unbounded_.end()) unbounded_.remove_swap(int(at - unbounded_.begin()));
}

void Broadphase::leave_tree(Proxy& p)
{
    if (p.leaf >= 0) {
        tree_changes();
        tree_.remove(p.leaf);
    }
    p.leaf = -1;
}

// Gives the slot its new place, among the leaves or the unbounded boxes.
bool Broadphase::place(int slot, bool in_bulk)
{
    Proxy& p = proxies_[slot];
    p.escaped = false;
    if (!p.present) return true;
    leave_unbounded(slot);
    if (!bounded(p.box)) {
        leave_tree(p);
        (void)unbounded_.push(slot);
    } else if (p.leaf < 0) {
        p.leaf = in_bulk ? tree_.insert_loose(fatten(p), slot) : tree_.insert(fatten(p), slot);
        p.escaped = p.leaf < 0;
        if (p.escaped) return false;
    } else if (in_bulk) {
        tree_.set_box(p.leaf, fatten(p));
    } else {
        tree_.move(p.leaf, fatten(p));
    }
    p.settled = true;
    if (!p.fresh) (void)fresh_.push(slot);
    p.fresh = true;
    return true;
}

bool Broadphase::find_pairs(const Tasks& tasks)
{
    if (!update_tree(tasks)) return false;
    if (fresh_.empty() && !stale_pairs_) return true;
    drop_stale_pairs();
    if (fresh_.empty()) return true;
    const bool many_fresh = fresh_.size() > tree_.leaf_count() / 3;
    if (!(many_fresh ? collect_all(tasks) : collect_fresh(tasks)) || !sort_found() || !merge_found())
        return false;
    for (int slot : fresh_) proxies_[slot].fresh = false;
    fresh_.clear();
    return true;
}

// Pairs of slots that have been removed or will be queried again.
void Broadphase::drop_stale_pairs()
{
    auto stale = [&](int slot) {
        const Proxy& p = proxies_.data()[slot];
        return !p.present || p.fresh;
    };
    int kept = 0;
    for (const SlotPair& pair : pairs_)
        if (!stale(pair.newer) && !stale(pair.older)) pairs_.data()[kept++] = pair;
    pairs_.truncate(kept);
    stale_pairs_ = false;
}

// The order in which pairs are found is of no importance, since they are sorted; but the parts are the same
// on any number of workers beyond one, so that no worker's list has to grow at another time.
// look(part, parts, found): false when memory is exhausted.
template <typename Look>
bool Broadphase::in_parts(const Tasks& tasks, Look&& look)
{
    const int parts = tasks.workers() > 1 ? kParts : 1;
    bool complete[kParts];
    for (Found& found : parts_) found.clear();
    tasks.for_each(parts, [&](int part, int) { complete[part] = look(part, parts, parts_[part]); });
    return std::all_of(complete, complete + parts, [](bool c) { return c; });
}

bool Broadphase::collect_fresh(const Tasks& tasks)
{
    const int count = fresh_.size();
    return in_parts(tasks, [&](int part, int parts, Found& found) {
        bool complete = true;
        const int begin = int((long long)count * part / parts),
                  end = int((long long)count * (part + 1) / parts);
        for (int i = begin; i < end && complete; ++i) complete = collect(fresh_.data()[i], found);
        return complete;
    });
}

// The partners of one fresh slot. Two fresh slots find each other; the newer one keeps the pair.
bool Broadphase::collect(int slot, Found& found) const
{
    const Proxy& p = proxies_.data()[slot];
    if (!p.present) return true;
    bool stored = true;
    query_fat(fat_box(p), [&](int other) {
        if (other < slot || (other > slot && !proxies_.data()[other].fresh))
            stored = keep(found, slot, other) && stored;
    });
    return stored;
}

bool Broadphase::keep_fresh(int a, int b, Found& found) const
{
    const Proxy* proxies = proxies_.data();
    return !(proxies[a].fresh || proxies[b].fresh) || keep(found, a, b);
}

// The pairs of all fresh slots at once.
bool Broadphase::collect_all(const Tasks& tasks)
{
    const int subtrees = tasks.workers() > 1 ? 8 * kParts : 1;  // they differ in size
    if (!tree_.split_pairs(subtrees, subtrees_)) return false;
    return in_parts(tasks, [&](int part, int parts, Found& found) {
        bool stored = part > 0 || collect_unbounded(found);
        const auto visit = [&](int a, int b) { stored = keep_fresh(a, b, found) && stored; };
        for (int i = part; i < subtrees_.size(); i += parts) tree_.query_pairs(subtrees_.data()[i], visit);
        return stored;
    });
}

bool Broadphase::collect_unbounded(Found& found) const
{
    const Proxy* proxies = proxies_.data();
    bool stored = true;
    const auto visit = [&](int a, int b) { stored = keep_fresh(a, b, found) && stored; };
    for (int i = 0; i < unbounded_.size(); ++i) {
        const int slot = unbounded_[i];
        tree_.query(proxies[slot].box, [&](int other) { visit(slot, other); });
        for (int k = 0; k < i; ++k)
            if (overlap(proxies[slot].box, proxies[unbounded_[k]].box)) visit(slot, unbounded_[k]);
    }
    return stored;
}

bool Broadphase::join_found()
{
    found_.clear();
    for (const Found& part : parts_) {
        const int at = found_.size();
        if (!found_.extend(part.size())) return false;
        std::copy(part.begin(), part.end(), found_.data() + at);
    }
    return true;
}

// Many pairs go to one bucket per newer slot first; what is left to sort are a few partners each.
bool Broadphase::sort_found()
{
    const int slots = proxies_.size();
    int count = 0;
    for (const Found& part : parts_) count += part.size();
    if (count < slots / 8) {
        if (!join_found()) return false;
        std::sort(found_.begin(), found_.end(), in_order);
        return true;
    }
    first_of_.clear();
    sorted_.clear();
    if (!first_of_.resize(slots + 1) || !sorted_.extend(count)) return false;
    int* first = first_of_.data();
    for (const Found& part : parts_)
        for (const SlotPair& pair : part) ++first[pair.newer];
    for (int slot = slots, sum = 0; slot >= 0; --slot) first[slot] = sum += first[slot];
    // first[s] is the end of bucket s now; filling from behind turns it into the beginning.
    for (const Found& part : parts_)
        for (const SlotPair& pair : part) sorted_.data()[--first[pair.newer]] = pair;
    for (int begin = 0; begin < sorted_.size();) {
        int end = begin + 1;
        while (end < sorted_.size() && sorted_.data()[end].newer == sorted_.data()[begin].newer) ++end;
        std::sort(sorted_.data() + begin, sorted_.data() + end, in_order);
        begin = end;
    }
    found_.swap(sorted_);
    return true;
}

// Merges what was found into the list, from behind, so that it needs no second list.
bool Broadphase::merge_found()
{
    if (pairs_.empty()) {
        pairs_.swap(found_);
        return true;
    }
    int a = pairs_.size() - 1, b = found_.size() - 1;
    if (!pairs_.resize(pairs_.size() + found_.size())) return false;
    for (int to = pairs_.size() - 1; b >= 0; --to) {
        const bool old_last = a >= 0 && in_order(found_[b], pairs_[a]);
        pairs_[to] = old_last ? pairs_[a--] : found_[b--];
    }
    return true;
}

}  // namespace epode
