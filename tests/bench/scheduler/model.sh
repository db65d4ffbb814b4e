# Sleeps as long as the factors and chance (the seed) say, then answers with a smooth function and some scatter.
awk -v f=${friction} -v r=${rolling} -v s=${seed} 'BEGIN {
    srand(s % 2147483647); a = rand(); b = rand(); c = rand()
    printf "%.3f\n", 3 + 3 * f + 5 * r + 1.0 * a > "seconds"
    printf "{\"angle_deg\": %.4f, \"flow_kg_s\": %.5f}\n", 20 + 20 * f * (1 - f / 3) + 15 * r + 0.2 * (b - 0.5), 3 - f - r + 0.01 * (c - 0.5) > "results.json"
}'
sleep $(cat seconds)
