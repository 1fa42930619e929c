"""The same sweep by threads, by processes, by a cluster of Dask and by one of Ray, each of two workers: equal rows are required, times printed.

    python benches/python/clusters.py [SPECS]

Needs `pip install . "dask[distributed]" ray`.
"""

import sys
import time
from concurrent.futures import ProcessPoolExecutor

import mavc

WORKERS = 2


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    masses = [1.4 + 0.6 * i / count for i in range(count)]

    def swept(name: str, client=None) -> str:
        start = time.perf_counter()
        table = mavc.sweep(mavc.new(), grid={"vehicle.mass": masses}, run="plan", client=client, workers=WORKERS)
        print(f"{name:10} {count} plans in {time.perf_counter() - start:.2f} s")
        return table.csv

    expected = swept("threads")
    with ProcessPoolExecutor(WORKERS) as pool:
        assert swept("processes", pool) == expected

    import dask.distributed

    with dask.distributed.LocalCluster(n_workers=WORKERS, threads_per_worker=1, dashboard_address=None) as cluster:
        with dask.distributed.Client(cluster) as client:
            assert swept("dask", client) == expected

    import ray

    ray.init(num_cpus=WORKERS, include_dashboard=False, log_to_driver=False)
    assert swept("ray", ray) == expected
    ray.shutdown()
    print("all rows are equal")


if __name__ == "__main__":
    main()
